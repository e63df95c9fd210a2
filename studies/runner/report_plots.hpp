#pragma once

#include "studies/plots/plot.hpp"
#include "studies/runner/result.hpp"

#include <span>
#include <vector>

namespace studies {

// What a report draws. A method has one colour and mark in all plots: its place in the study.

/// Permeability over that of the reference, one line per case, with error bars: all answers, and when they lie far
/// apart once more what is near 1. Nothing without a reference to compare with.
std::vector<Plot> permeability_plots(const Study& study, std::span<const Result> results);

/// Error of the permeability of every run against its CPU seconds: every case whose reference has an error bar or needs
/// none, as it has no mesh; medians over the cases of a method and mesh size; what none of these is both faster and
/// closer than. Bars are the reference's own error. Empty without such a case and for a study of how cost grows.
Plot error_plot(const Study& study, std::span<const Result> results);

/// CPU seconds and memory against the number of spheres, when the study asks how cost grows.
std::vector<Plot> scaling_plots(const Study& study, std::span<const Result> results);

} // namespace studies
