#pragma once

#include "studies/motion/coupled_speed.hpp"
#include "studies/motion/scheme_speed.hpp"

namespace studies {

/// What the ratios are to reach: dry steps over those of LIGGGHTS, coupled ones over those of YADE, simulated time of
/// semi-implicit over explicit steps.
struct SpeedBounds {
  double dry = 1, coupled = 4, scheme = 5;
};

/// Steps per CPU second, each against a peer in the same run.
struct Speed {
  SpeedBounds bounds;
  std::vector<DrySpeed> dry;
  CoupledSpeed coupled;
  SchemeSpeed scheme;
};

ExperimentReport speed_report(const Speed& speed);
ExperimentReport run_speed(bool quick, const Say& say);

inline constexpr Experiment speed_experiment{
    "speed", "Steps per CPU second: dry grains, the coupled oedometer, and what semi-implicit steps gain",
    "How many steps per CPU second do grains take, dry and with fluid, beside the programs that people use for the "
    "same, "
    "and how much sooner is a semi-implicit run done than an explicit one?",
    run_speed};

} // namespace studies
