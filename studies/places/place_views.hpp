#pragma once

#include "studies/document/document.hpp"
#include "studies/places/place_case.hpp"

#include <span>

namespace studies {

// Each adds what the cases say of one kind of place to a page, and nothing when they say nothing.

/// Table of differences, profile along the flow, scatter, and a cut through the first case of a random packing.
void add_pressures(std::span<const PlaceCase> cases, const Study& study, Document& page);

/// Table of differences, in all and by the size of the spheres, share of shear, scatter of both.
void add_forces(std::span<const PlaceCase> cases, const Study& study, Document& page);

/// Table of the conductances by how open the throats are, scatter of fluxes, and conductances against openness.
void add_throats(std::span<const PlaceCase> cases, const Study& study, Document& page);

} // namespace studies
