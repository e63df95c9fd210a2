#pragma once

#include "pfv/problem/packing.hpp"
#include "studies/document/document.hpp"
#include "studies/runner/result.hpp"

#include <span>
#include <string>
#include <vector>

namespace studies {

/// Spheres in their box as SVG for a page, seen from above and one side without perspective, the far ones first. With
/// one value per sphere they have colours, from dark for zero to bright for the largest value, and `unit` tells it. No
/// graphics library, so that a report needs no display.
std::string packing_picture(const pfv::Packing& packing, std::span<const double> values, const std::string& unit,
                            const std::string& id_prefix);

/// Pictures of the first cases that differ in their number of spheres and are small enough to be seen, coloured by the
/// forces of the reference, or of the first method that has any.
std::vector<Figure> packing_figures(const Study& study, std::span<const Result> results);

} // namespace studies
