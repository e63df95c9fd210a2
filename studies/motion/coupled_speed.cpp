#include "studies/motion/coupled_speed.hpp"

#include "pfv/problem/generate.hpp"
#include "pfv/simulation/relax.hpp"
#include "pfv/simulation/simulation.hpp"
#include "reference/yade/program.hpp"
#include "studies/motion/yade_oedometer.hpp"

#include <fmt/format.h>

namespace studies {

namespace {

using namespace pfv;

/// The example's figures: scripts/examples of FlowEngine, oedometer.
struct Example {
  double side = 1, young = 1e6, tangential_ratio = 0.5, friction = 0.577, density = 2600; // m, Pa, -, -, kg/m^3
  double stress = 10e3, load = 1e3, viscosity = 10;                                       // Pa, Pa, Pa s
  double step = 1e-4;                                                                     // s
};

constexpr double solid_fraction = 0.58;
constexpr double piston = 0.05;     // of the mass of the grains: YADE's has none
constexpr double wall_limit = 3600; // s

GrainScene grain_scene(const Example& example, double stress, double friction) {
  GrainScene scene;
  scene.density = example.density;
  scene.law = LinearSprings{example.young, example.tangential_ratio, {friction, 0}};
  const double mass = piston * scene.density * solid_fraction * example.side * example.side * example.side;
  scene.walls.motion[index(Face::z_max)] = LoadedWall{stress, mass};
  return scene;
}

/// From all sides with little friction, as the example does it, then with that of the test under the piston alone.
GrainCycle pressed(const Example& example, int grains) {
  GrainScene scene = grain_scene(example, example.stress, 0.05);
  scene.damping.share = 0.3;
  for (const Face face : {Face::x_max, Face::y_max})
    scene.walls.motion[index(face)] = scene.walls.motion[index(Face::z_max)];
  GrainCycle cycle(random_packing({.spheres = grains,
                                   .solid_fraction = solid_fraction,
                                   .radius_ratio = 1.35,
                                   .seed = 1,
                                   .size = example.side,
                                   .periodic = {}}),
                   scene);
  Clock clock;
  relax(cycle, {2e-3, 1e-2}, clock);
  scene = grain_scene(example, example.stress, example.friction);
  scene.damping.share = 0.3;
  cycle.set_scene(scene);
  relax(cycle, {1e-4}, clock);
  return cycle;
}

Scene wet(const Example& example) {
  Scene scene;
  scene.grains = grain_scene(example, example.stress + example.load, example.friction);
  scene.fluid.emplace();
  scene.fluid->faces[index(Face::z_max)] = Pressure{0};
  scene.fluid->fluid.viscosity = example.viscosity;
  return scene;
}

double height(const Simulation& simulation) {
  return simulation.grains().grains.packing.box.size().z();
}

/// CPU seconds of a step.
double advance(Simulation& simulation, std::size_t steps) {
  const double start = process_cpu_seconds();
  for (std::size_t n = 0; n < steps; ++n)
    simulation.advance();
  return (process_cpu_seconds() - start) / static_cast<double>(steps);
}

void their_turn(const Example& example, const Packing& packing, CoupledSpeed& speed) {
  const YadeOedometerReply reply = run_yade_oedometer(packing,
                                                      {.young = example.young,
                                                       .tangential_ratio = example.tangential_ratio,
                                                       .friction = example.friction,
                                                       .density = example.density,
                                                       .stress = example.stress,
                                                       .load = example.load,
                                                       .viscosity = example.viscosity,
                                                       .step = example.step,
                                                       .steps = speed.steps},
                                                      wall_limit);
  speed.version = reply.version;
  speed.theirs->cpu_seconds.push_back(reply.cpu_seconds);
  speed.their_settlement = reply.settlement;
}

} // namespace

CoupledSpeed coupled_speed(int grains, std::size_t steps, int turns, const Say& say) {
  const Example example;
  say(fmt::format("pressing {} grains", grains), 0);
  const GrainCycle start = pressed(example, grains);
  CoupledSpeed speed;
  speed.grains = grains;
  speed.step = example.step;
  speed.steps = steps;
  if (!reference::yade::missing_program())
    speed.theirs.emplace();
  for (int turn = 0; turn < turns; ++turn) {
    say("oedometer under water", static_cast<double>(turn) / turns);
    Scene scene = wet(example);
    scene.step = example.step;
    Simulation simulation(scene, start);
    const double before = height(simulation);
    simulation.advance();
    speed.ours.cpu_seconds.push_back(advance(simulation, steps));
    speed.settlement = before - height(simulation);
    speed.pores = simulation.fluid()->network().pores.size();
    speed.stages = simulation.clock().stages();
    const PoreFluid& fluid = *simulation.fluid();
    speed.counts = {fluid.refreshed, fluid.rebuilt, fluid.iterations, fluid.solves};

    scene.step.reset();
    Simulation longer(scene, start);
    longer.advance();
    speed.our_step = longer.step();
    const double same_time = static_cast<double>(steps) * example.step;
    speed.at_our_step.cpu_seconds.push_back(advance(longer, static_cast<std::size_t>(same_time / longer.step())));
    if (speed.theirs)
      their_turn(example, packing_of(start.grains), speed);
  }
  return speed;
}

} // namespace studies
