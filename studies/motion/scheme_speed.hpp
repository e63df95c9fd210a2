#pragma once

#include "studies/motion/experiment.hpp"

namespace studies {

/// Explicit against semi-implicit on the layer of the study `consolidation`, in a fluid so viscous that it would have
/// an explicit step a tenth as long as the contacts do.
struct SchemeSpeed {
  int grains = 0;
  double duration = 0;                              // s, that both advance from the same load
  double step = 0, implicit_step = 0;               // s
  double cpu_seconds = 0, implicit_cpu_seconds = 0; // of the whole duration
  double settlement = 0, implicit_settlement = 0;   // m, after it
};

SchemeSpeed scheme_speed(int grains, double duration, const Say& say);

} // namespace studies
