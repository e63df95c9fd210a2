#include "reference/lattice_boltzmann/lattice_flow/settling.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace reference::lattice_boltzmann {

namespace {

// Never less than the change itself: the flow may ring. Where changes do not shrink, a hundred more are expected.
double still_to_come(double before, double last) {
  const double ratio = before == 0 ? 1 : std::min(std::abs(last / before), 1.0);
  return std::abs(last) * std::max(1.0, ratio / std::max(1 - ratio, 0.01));
}

} // namespace

void Settling::add(double velocity) {
  std::shift_right(last_.begin(), last_.end(), 1);
  last_[0] = velocity;
  ++count_;
}

double Settling::drift() const {
  if (count_ < 4 || last_[0] == 0)
    return std::numeric_limits<double>::infinity();
  return std::max(still_to_come(last_[1] - last_[2], last_[0] - last_[1]),
                  still_to_come(last_[2] - last_[3], last_[1] - last_[2])) /
         std::abs(last_[0]);
}

} // namespace reference::lattice_boltzmann
