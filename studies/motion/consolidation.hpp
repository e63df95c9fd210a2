#pragma once

#include "studies/motion/experiment.hpp"
#include "studies/motion/oedometer.hpp"

#include <span>

namespace studies {

/// How far a test is from Terzaghi's solution for its layer: over all moments with 0.05 <= T <= 1, relative to the
/// final settlement and to the load.
struct ConsolidationError {
  double largest_settlement = 0, rms_settlement = 0;
  double largest_pressure = 0, rms_pressure = 0; // at half of the height
};

/// Settlement of the piston over the final one: the ends at once, the rest as Terzaghi says.
double expected_settlement(const Layer& layer, double time_factor);
/// Excess pressure over the load at a share of the height; zero beyond the drained planes.
double expected_pressure(const Layer& layer, double time_factor, double share);

ConsolidationError error_of(const Consolidation& test);

/// A layer that differs by its seed alone.
struct OtherLayer {
  unsigned seed;
  ConsolidationError error;
};

/// Of one test, told in full, and of the errors of other layers; the worst of all is held against the bounds.
ExperimentReport consolidation_report(const Consolidation& test, const Oedometer& asked,
                                      std::span<const OtherLayer> others = {});
ExperimentReport run_consolidation(bool quick, const Say& say);

inline constexpr Experiment consolidation_experiment{"consolidation",
                                                     "Consolidation of a layer of grains against Terzaghi's solution",
                                                     "Does a layer of grains with fluid in its pores settle, and does "
                                                     "the pressure in it fall, as Terzaghi's theory says, "
                                                     "with nothing fitted?",
                                                     run_consolidation};

} // namespace studies
