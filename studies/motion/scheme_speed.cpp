#include "studies/motion/scheme_speed.hpp"

#include "studies/motion/oedometer.hpp"

#include <fmt/format.h>

namespace studies {
namespace {

using namespace pfv;

constexpr double ratio = 0.1; // of the explicit step that the fluid allows to the one that contacts do

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

  SchemeSpeed speed{grains, duration, course(scene, start, duration, say), {}};
  scene.scheme = SemiImplicit{};
  speed.implicit = course(scene, start, duration, say);
  return speed;
}

} // namespace studies
