#pragma once

#include "studies/document/table.hpp"
#include "studies/runner/result.hpp"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace studies {

/// What it takes a method to be within a relative error of the permeability.
struct CostOfAccuracy {
  std::vector<double> cpu_seconds; // meshing included: one for each case where it is
  std::size_t cases = 0;           // that it was asked and whose reference is known well enough to tell
};

/// Of the coarsest mesh of a method that is within the level and has no finer one outside, so that no crossing by luck
/// counts; or of the extrapolation from all its meshes, which costs them all. A run is within the level when its
/// distance from the reference's extrapolated value and the reference's own error are together; a reference whose error
/// is above half of the level tells nothing. The extrapolation of the reference itself is as far off as its error says.
CostOfAccuracy cost_of_accuracy(const Study& study, std::span<const Result> results, const std::string& method,
                                double level, bool extrapolated);

/// A line for each method, and for the extrapolation of each with several meshes; a column for each level that the
/// study's [accuracy] asks for: the median over the cases, and in how many of them it is reached.
Table accuracy_table(const Study& study, std::span<const Result> results);

} // namespace studies
