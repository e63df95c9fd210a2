#pragma once

#include <array>

namespace reference::lattice_boltzmann {

/// Tells when a mean velocity looked at again and again at equal intervals has come to rest: changes that shrink like a
/// geometric series leave d r / (1 - r) to come, d the last change and r its ratio to the one before.
class Settling {
public:
  void add(double velocity);
  /// Still to come, relative to the last velocity; infinite before there have been four.
  double drift() const;

private:
  std::array<double, 4> last_{}; // newest first
  int count_ = 0;
};

} // namespace reference::lattice_boltzmann
