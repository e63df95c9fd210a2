#pragma once

namespace studies {

/// What one run may take. A run whose estimate is above it is not started.
struct Budget {
  double cpu_seconds = 300;
  double memory_bytes = 4e9;  // estimates are right to a factor of 2: no process of a run gets more than twice this
  double wall_seconds = 1800; // a run that takes longer is stopped and failed

  bool operator==(const Budget&) const = default;
};

} // namespace studies
