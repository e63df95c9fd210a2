#include "pfv/simulation/carry_over.hpp"

#include <algorithm>

namespace pfv {
namespace {

struct Remembered {
  std::array<int, 4> bodies;
  double pressure;
};

std::array<int, 4> sorted(std::array<int, 4> bodies) {
  std::ranges::sort(bodies);
  return bodies;
}

} // namespace

std::vector<double> carried_over(const std::vector<std::array<int, 4>>& old_bodies, const std::vector<double>& pressure,
                                 const std::vector<std::array<int, 4>>& new_bodies, std::size_t bodies) {
  std::vector<double> sum(bodies, 0.0), count(bodies, 0.0);
  std::vector<Remembered> old;
  old.reserve(old_bodies.size());
  for (std::size_t i = 0; i < old_bodies.size(); ++i) {
    old.push_back({sorted(old_bodies[i]), pressure[i]});
    for (const int body : old_bodies[i]) {
      sum[body] += pressure[i];
      ++count[body];
    }
  }
  std::ranges::sort(old, {}, &Remembered::bodies);
  std::vector<double> carried(new_bodies.size());
  for (std::size_t i = 0; i < new_bodies.size(); ++i) {
    const auto key = sorted(new_bodies[i]);
    const auto found = std::ranges::lower_bound(old, key, {}, &Remembered::bodies);
    if (found != old.end() && found->bodies == key) {
      carried[i] = found->pressure;
      continue;
    }
    double mean = 0;
    int known = 0;
    for (const int body : new_bodies[i])
      if (count[body] > 0) {
        mean += sum[body] / count[body];
        ++known;
      }
    carried[i] = known > 0 ? mean / known : 0;
  }
  return carried;
}

} // namespace pfv
