#pragma once

#include "studies/document/table.hpp"
#include "studies/runner/result.hpp"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace studies {

struct TitledTable {
  std::string title;
  Table table;
};

/// The slope between two points in logarithms, ln(large / small) / ln(n_large / n_small); nothing when a value is not
/// positive or both are for the same n.
std::optional<double> exponent(double n_small, double small, double n_large, double large);

/// How cost grows with the number of spheres, as the study's [scaling] asks for it; nothing when it does not. For each
/// method: CPU seconds by stage, in all and per sphere, those of a repeated step, memory; then the exponents of the
/// same between successive sizes. Last the ratios to the method the study compares with. A run without an answer keeps
/// its line and says why.
std::vector<TitledTable> scaling_tables(const Study& study, std::span<const Result> results);

} // namespace studies
