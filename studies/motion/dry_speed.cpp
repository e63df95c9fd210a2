#include "studies/motion/dry_speed.hpp"

#include "pfv/grains/contact_list.hpp"
#include "pfv/problem/generate.hpp"
#include "pfv/simulation/relax.hpp"
#include "pfv/simulation/simulation.hpp"
#include "studies/motion/liggghts.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace studies {
namespace {

using namespace pfv;

constexpr double side = 0.1, solid_fraction = 0.58, stress = 50e3; // m, -, Pa
constexpr Friction rubbing{0.5, 0.015};

Packing pressed(int grains) {
  GrainScene scene;
  scene.law = LinearSprings{1e7, 0.5, {0.1, 0}};
  scene.walls.motion[index(Face::z_max)] = LoadedWall{stress, scene.density * solid_fraction * side * side * side};
  scene.damping.share = 0.3;
  GrainCycle cycle(random_packing({.spheres = grains,
                                   .solid_fraction = solid_fraction,
                                   .radius_ratio = 1.35,
                                   .seed = 1,
                                   .size = side,
                                   .periodic = {}}),
                   scene);
  Clock clock;
  relax(cycle, {1e-3, 1e-2}, clock);
  return packing_of(cycle.grains);
}

GrainScene scene_of(const ContactLaw& law) {
  GrainScene scene;
  scene.law = law;
  scene.walls.friction = friction_of(law).coefficient;
  return scene;
}

/// What LIGGGHTS calls kinetic energy.
double energy_of_translation(const Grains& grains) {
  double energy = 0;
  for (std::size_t i = 0; i < grains.size(); ++i)
    energy += 0.5 * grains.mass[i] * grains.velocity[i].translation.squaredNorm();
  return energy;
}

void our_turn(const Packing& packing, const GrainScene& scene, DrySpeed& speed) {
  GrainCycle cycle(packing, scene);
  Clock clock, ignored;
  for (std::size_t n = 0; n < speed.steps / 4; ++n)
    cycle.advance(speed.step, ignored);
  speed.our_energy = energy_of_translation(cycle.grains);
  const double start = process_cpu_seconds();
  for (std::size_t n = 0; n < speed.steps; ++n)
    cycle.advance(speed.step, clock);
  speed.ours.cpu_seconds.push_back((process_cpu_seconds() - start) / static_cast<double>(speed.steps));
  speed.stages = clock.stages();
}

void their_turn(const Packing& packing, const GrainScene& scene, DrySpeed& speed) {
  const LiggghtsRun run = run_liggghts(packing, scene.law, scene.density, speed.step, speed.steps / 4, speed.steps);
  speed.their_energy = run.kinetic_energy;
  speed.theirs->cpu_seconds.push_back(run.cpu_seconds);
}

} // namespace

double Turns::median() const {
  std::vector<double> sorted = cpu_seconds;
  std::ranges::sort(sorted);
  return sorted.at(sorted.size() / 2);
}

std::vector<DrySpeed> dry_speeds(int grains, std::size_t steps, int turns, const Say& say) {
  say(fmt::format("pressing {} grains", grains), 0);
  const Packing packing = pressed(grains);
  std::vector<DrySpeed> list;
  for (const ContactLaw& law : {ContactLaw(ConstantSprings{5e4, 2.5e4, {rubbing.coefficient, 0}}),
                                ContactLaw(HertzMindlin{1e9, 0.3, rubbing})}) {
    const GrainScene scene = scene_of(law);
    GrainCycle start(packing, scene);
    DrySpeed speed;
    speed.grains = grains;
    speed.law = std::visit([](const auto& one) { return one.name; }, law);
    speed.steps = steps;
    speed.step = limits_of(start).chosen();
    Clock clock;
    start.load(speed.step, clock);
    speed.contacts = contact_list(start.grains, start.contacts).size();
    if (!missing_liggghts())
      speed.theirs.emplace();
    for (int turn = 0; turn < turns; ++turn) {
      say(fmt::format("{} dry grains, {}", grains, speed.law), static_cast<double>(turn) / turns);
      our_turn(packing, scene, speed);
      if (speed.theirs)
        their_turn(packing, scene, speed);
    }
    list.push_back(std::move(speed));
  }
  return list;
}

} // namespace studies
