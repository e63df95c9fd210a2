#pragma once

#include "studies/document/document.hpp"
#include "studies/places/place_case.hpp"

#include <span>
#include <vector>

namespace studies {

/// The case that is drawn: the first with random spheres, else the first, or none.
const PlaceCase* shown_case(std::span<const PlaceCase> cases);

/// The reference's pressures in the pores as shares of what they span; none where no other method has any to compare.
struct Shares {
  double least, most;          // Pa
  std::vector<double> of_pore; // NaN where unknown
};

Shares reference_shares(const PlaceCase& viewed);

/// The plane through the middle of the box that holds the flow's axis, with every pore it cuts in the colour of its
/// pressure and the spheres in grey: of shown_case(), the pressures of the reference, then of
/// every other method what it differs by.
std::vector<Figure> pressure_cuts(std::span<const PlaceCase> cases);

} // namespace studies
