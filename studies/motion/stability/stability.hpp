#pragma once

#include "studies/motion/experiment.hpp"
#include "studies/motion/stability/trial.hpp"

namespace studies {

/// All hard cases, or those of a quick run.
std::vector<Trial> hard_cases(bool quick);

/// All of them, one after the other, whatever becomes of one.
std::vector<TrialRow> tried_all(const std::vector<Trial>& trials, const Say& say);

ExperimentReport stability_report(const std::vector<TrialRow>& rows);
ExperimentReport run_stability(bool quick, const Say& say);

inline constexpr Experiment stability_experiment{
    "stability", "Hard cases: degenerate, extreme and unstable ones, each held by a measure",
    "Do hard cases stay numerically stable: fluxes that balance, pressures within those imposed, energy that is "
    "accounted for, forces that do not jump, steps that are stable up to the predicted limit? And what does the "
    "original "
    "implementation do with the same cases?",
    run_stability};

} // namespace studies
