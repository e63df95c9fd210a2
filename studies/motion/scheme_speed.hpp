#pragma once

#include "studies/motion/experiment.hpp"

namespace studies {

/// One scheme from the load on.
struct Course {
  double step = 0;        // s
  double cpu_seconds = 0; // of all steps
  double settlement = 0;  // m, at the end
};

/// Explicit against semi-implicit on the layer of the study `consolidation`, in a fluid so viscous that it would have
/// an explicit step a tenth as long as the contacts do.
struct SchemeSpeed {
  int grains = 0;
  double duration = 0; // s
  Course lagging, implicit;

  /// Simulated time per CPU second, semi-implicit over explicit.
  double gain() const { return lagging.cpu_seconds / implicit.cpu_seconds; }
};

SchemeSpeed scheme_speed(int grains, double duration, const Say& say);

} // namespace studies
