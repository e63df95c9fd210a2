#include "studies/motion/speed.hpp"

namespace studies {

namespace {

/// Of 1000 grains in a few steps, once, on whatever else the machine does: half of what more of them reach.
constexpr SpeedBounds quick_bounds{0.5, 2, 2};

} // namespace

ExperimentReport run_speed(bool quick, const Say& say) {
  Speed speed;
  if (quick)
    speed.bounds = quick_bounds;
  const int turns = quick ? 1 : 5;
  const auto add_dry = [&](int grains, std::size_t steps) {
    for (DrySpeed& one : dry_speeds(grains, steps, turns, say))
      speed.dry.push_back(std::move(one));
  };
  add_dry(quick ? 1000 : 5000, 1000);
  add_dry(quick ? 5000 : 50000, quick ? 200 : 150);
  speed.coupled = coupled_speed(quick ? 1000 : 5000, quick ? 200 : 800, quick ? 1 : 3, say);
  speed.scheme = scheme_speed(quick ? 1000 : 5000, quick ? 0.005 : 0.03, say);
  return speed_report(speed);
}

} // namespace studies
