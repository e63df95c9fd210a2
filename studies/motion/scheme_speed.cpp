#include "studies/motion/scheme_speed.hpp"

#include "studies/motion/oedometer.hpp"

#include <fmt/format.h>

namespace studies {
namespace {

using namespace pfv;

constexpr double ratio = 0.1; // of the explicit step that the fluid allows to the one that contacts do

/// One scheme over the whole duration.
struct Course {
  double step = 0, cpu_seconds = 0, settlement = 0;
};

Course course(const Scene& scene, const GrainCycle& start, double duration, const Say& say) {
  Simulation simulation(scene, start);
  const auto height = [&] { return simulation.grains().grains.packing.box.size().z(); };
  const double before = height(), began = simulation.grains().time, cpu_before = process_cpu_seconds();
  for (double done = 0; done < duration; done = simulation.grains().time - began) {
    simulation.advance();
    if (simulation.steps() % 50 == 0)
      say(std::visit([](const auto& one) { return std::string(one.name); }, scene.scheme), done / duration);
  }
  return {simulation.step(), process_cpu_seconds() - cpu_before, before - height()};
}

} // namespace

SchemeSpeed scheme_speed(int grains, double duration, const Say& say) {
  Oedometer test;
  test.grains = grains;
  say(fmt::format("compacting {} grains", grains), 0);
  Clock clock;
  const GrainCycle start = compacted(test, clock);
  Scene scene = under_load(test, 1);
  scene.scheme = Explicit{};
  const StepLimits limits = Simulation(scene, start).limits();
  scene.fluid->fluid.viscosity = *limits.viscous / StepLimits{limits.contact}.chosen() / ratio;

  SchemeSpeed speed;
  speed.grains = grains;
  speed.duration = duration;
  const Course lagging = course(scene, start, duration, say);
  scene.scheme = SemiImplicit{};
  const Course implicit = course(scene, start, duration, say);
  speed.step = lagging.step;
  speed.cpu_seconds = lagging.cpu_seconds;
  speed.settlement = lagging.settlement;
  speed.implicit_step = implicit.step;
  speed.implicit_cpu_seconds = implicit.cpu_seconds;
  speed.implicit_settlement = implicit.settlement;
  return speed;
}

} // namespace studies
