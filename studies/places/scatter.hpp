#pragma once

#include "studies/places/place_case.hpp"
#include "studies/plots/plot.hpp"

#include <functional>
#include <span>
#include <string>
#include <vector>

namespace studies {

/// The pairs of a case that are to be drawn, and what both values are divided by.
using ChoosePairs = std::function<std::vector<PlacePairs>(const PlaceCase&)>;
using ChooseUnit = std::function<double(const PlaceCase&)>;

/// What each method says against what the reference says, over all cases, and the line on which both are the same.
Plot scatter(std::span<const PlaceCase> cases, const Study& study, const std::string& what, std::string caption,
             const ChoosePairs& choose, const ChooseUnit& unit);

/// The place of a method in its study, which gives it its colour.
int look_of(const Study& study, const std::string& method);

} // namespace studies
