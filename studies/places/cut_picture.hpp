#pragma once

#include "studies/document/document.hpp"
#include "studies/places/place_case.hpp"

#include <span>
#include <vector>

namespace studies {

/// The plane through the middle of the box that holds the flow's axis, with every pore it cuts in the colour of its
/// pressure and the spheres in grey: of the first case with random spheres, the pressures of the reference, then of
/// every other method what it differs by.
std::vector<Figure> pressure_cuts(std::span<const PlaceCase> cases);

} // namespace studies
