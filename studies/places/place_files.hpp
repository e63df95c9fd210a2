#pragma once

#include "studies/places/place_case.hpp"

#include <map>
#include <span>
#include <string>

namespace studies {

/// What is drawn, as numbers: pores.csv, spheres.csv and throats.csv, as the study's `places` ask, each with a line for
/// each place of all cases, its geometry, and a column for each method, the reference's first. Empty where unknown.
std::map<std::string, std::string> place_files(std::span<const PlaceCase> cases, const Study& study);

} // namespace studies
