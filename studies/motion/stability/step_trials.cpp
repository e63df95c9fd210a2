#include "studies/motion/stability/step_trials.hpp"

#include "pfv/problem/error.hpp"
#include "pfv/simulation/drained_box.hpp"
#include "pfv/simulation/energy_account.hpp"
#include "studies/motion/stability/original_motion.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace studies {

using namespace pfv;

namespace {

constexpr double viscosity = 300; // Pa s: the fluid's limit is then far below that of contacts
constexpr int grains = 150, steps = 3000;

Scene explicit_box(double ratio) {
  Scene scene = drained_box(grains, ratio, viscosity);
  scene.fluid->refresh_drift = 1; // so that the limit stays what it is
  return scene;
}

/// How an explicit run goes.
struct Course {
  double highest = 0;  // kinetic energy over the work of the load so far
  std::string message; // of the end, when it was stopped
};

Course run(Scene scene, double step, int most_steps) {
  scene.step = step;
  Simulation simulation(scene);
  EnergyAccount account(simulation);
  Course course;
  try {
    for (int n = 0; n < most_steps; ++n) {
      account.advance();
      const double work = std::max(1e-6, simulation.grains().energy.loads); // J; there is none at the start
      course.highest = std::max(course.highest, account.kinetic() / work);
    }
  } catch (const SolveError& error) {
    course.message = error.what();
  }
  return course;
}

bool names_the_limit(const std::string& message) {
  return message.find("left stability") != message.npos && message.find("s of the fluid") != message.npos;
}

Measured below(double ratio) {
  const Scene scene = explicit_box(ratio);
  const Course course = run(scene, 0.97 * Simulation(scene).limits().joint(), steps);
  // At most all of the work, but for what the energy balance may miss.
  return {{{"kinetic energy / work of the load, highest", course.highest, 0, 1.001},
           {"stopped", course.message.empty() ? 0.0 : 1.0, 0, 0}},
          course.message};
}

Measured above(double ratio, double share) {
  const Scene scene = explicit_box(ratio);
  const Course course = run(scene, share * *Simulation(scene).limits().viscous, 20000);
  return {{{"kinetic energy / work of the load, highest", course.highest, 1000},
           {"stopped", course.message.empty() ? 0.0 : 1.0, 1, 1},
           {"message names the limit", names_the_limit(course.message) ? 1.0 : 0.0, 1, 1}},
          course.message};
}

/// m, of the piston after a time.
double settled(Scene scene, double step, TimeScheme scheme, double until) {
  scene.step = step;
  scene.scheme = scheme;
  Simulation simulation(scene);
  const auto count = static_cast<int>(until / step + 0.5);
  for (int n = 0; n < count; ++n)
    simulation.advance();
  return scene.packing.box.size().z() - simulation.grains().grains.packing.box.size().z();
}

Measured far_beyond(double times, double most) {
  Scene scene = drained_box(grains, 1.35, 20 * viscosity);
  scene.grains.damping.share = 0.2;
  const StepLimits limits = Simulation(scene).limits();
  const double until = 10000 * *limits.viscous;
  const double reference = settled(scene, 0.8 * *limits.viscous, Explicit{}, until);
  const double ours = settled(scene, times * *limits.viscous, SemiImplicit{}, until);
  return {{{"step / limit of contacts", times * *limits.viscous / limits.contact},
           {"settlement by explicit steps, m", reference, 0},
           {"difference from it", ours / reference - 1, -most, most}}};
}

} // namespace

std::vector<Trial> explicit_trials() {
  std::vector<Trial> trials;
  const auto add = [&](const char* group, double ratio, const char* name, auto measured, std::vector<double> shares) {
    trials.push_back({group, fmt::format("size ratio {:g}, {}", ratio, name), ratio == 1.35,
                      [=] { return measured(ratio); },
                      [=] { return original_steps(drained_box(grains, ratio, viscosity), shares); }});
  };
  for (const double ratio : {1.35, 5.0}) {
    add("Explicit steps below the limit", ratio, "0.97 of it", below, {0.1, 0.3, 0.97});
    add("Explicit steps above the limit", ratio, "1.03 times", [](double of) { return above(of, 1.03); }, {1.03});
    add("Explicit steps above the limit", ratio, "3 times", [](double of) { return above(of, 3); }, {3});
  }
  return trials;
}

std::vector<Trial> implicit_trials() {
  std::vector<Trial> trials;
  for (const auto& [times, most] : {std::pair{20.0, 0.01}, std::pair{100.0, 0.02}})
    trials.push_back({"Semi-implicit steps", fmt::format("{:g} times the explicit limit", times), times == 100,
                      [=] { return far_beyond(times, most); }});
  return trials;
}

} // namespace studies
