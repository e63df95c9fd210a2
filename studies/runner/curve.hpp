#pragma once

#include "studies/plots/plot.hpp"
#include "studies/runner/result.hpp"
#include "studies/runner/scaling.hpp"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace studies {

/// What a method says of the cases of one label, which differ by chance only: means over them.
struct CurvePoint {
  std::string label;
  std::size_t cases = 0;
  double porosity = 0;         // 1 less the solid fraction, as the method has it
  double value = 0;            // k / d^2, d the Sauter diameter
  std::optional<double> error; // half of what the cases span, with the mean error of the answers; nothing without both
  std::optional<double> ratio; // k over that of the method compared with, where it answers all these cases
  std::optional<double> ratio_error; // half of what it spans, with the mean error of the answers
};

/// The curves that the study's cases name, in their order.
std::vector<std::string> curve_names(const Study& study);

/// Of the method on this curve, by porosity. A case counts when the method has a permeability and any method says the
/// packing's Sauter diameter.
std::vector<CurvePoint> curve_points(const Study& study, std::span<const Result> results, const std::string& curve,
                                     const std::string& method);

/// For each curve that has points: k / d^2, a line for each label, a column for each method; then k over that of the
/// method the study compares with. Nothing for a study without [curve].
std::vector<TitledTable> curve_tables(const Study& study, std::span<const Result> results);

/// The same as plots: k / d^2 on a logarithmic axis, and the ratio.
std::vector<Plot> curve_plots(const Study& study, std::span<const Result> results, const std::string& curve);

} // namespace studies
