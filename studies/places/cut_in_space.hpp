#pragma once

#include "studies/document/document.hpp"
#include "studies/places/place_case.hpp"
#include "studies/render/scene.hpp"

#include <vector>

namespace studies {

/// A packing without the quarter of its box that is nearest to the eye: on the two planes of the cut every pore has the
/// colour of its share, from 0 to 1; grey where that is not a number. The flow's axis points up.
RenderScene cut_in_space(const pfv::PoreNetwork& network, pfv::Axis axis, const std::vector<double>& shares);

/// That of the reference's pressures in shown_case(); nothing where there is none.
std::vector<Figure> pressure_in_space(std::span<const PlaceCase> cases);

} // namespace studies
