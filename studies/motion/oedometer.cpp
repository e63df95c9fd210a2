#include "studies/motion/oedometer.hpp"

#include "pfv/flow/steady_flow.hpp"
#include "pfv/grains/contact_list.hpp"
#include "pfv/problem/generate.hpp"
#include "pfv/simulation/relax.hpp"
#include "studies/motion/line_fit.hpp"

#include <algorithm>

namespace studies {
namespace {

using namespace pfv;

constexpr double damping = 0.3, damping_of_test = 0.2;
constexpr PeriodicAxes sideways{true, true, false};
constexpr double solid_fraction_at_start = 0.58;
constexpr std::size_t slices = 20;
constexpr std::size_t load_increments = 2, steps_of_an_increment = 4000;

double mass_of_grains(const Oedometer& test) {
  return GrainScene{}.density * solid_fraction_at_start * test.side * test.side * test.side;
}

GrainScene grain_scene(const Oedometer& test, double stress, double friction, double damping_share) {
  GrainScene scene;
  scene.law = LinearSprings{test.young, 0.5, {friction, 0}};
  scene.walls.periodic = sideways;
  scene.walls.motion[index(Face::z_max)] = LoadedWall{stress, mass_of_grains(test)};
  scene.damping.share = damping_share;
  return scene;
}

double height(const GrainCycle& cycle) {
  return cycle.grains.packing.box.size().z();
}

/// Permeabilities, and where the line of pressures in the middle meets the imposed ones.
SteadyFlow measure_permeability(const GrainCycle& cycle, Layer& layer, Clock& clock) {
  Case problem;
  problem.packing = packing_of(cycle.grains);
  problem.faces = flow_along(Axis::z, 1.0, sideways, problem.packing.box);
  SteadyFlow flow = solve_steady_flow(problem, {}, clock);
  LineFit line;
  for (std::size_t i = 0; i < flow.pressure.size(); ++i) {
    const double z = (flow.network.pores.centre[i].z() - problem.packing.box.lower.z()) / layer.height;
    if (z > 0.15 && z < 0.85)
      line.add(z, flow.pressure[i], flow.network.pores.void_volume[i]);
  }
  layer.porosity = flow.network.porosity();
  layer.permeability_of_box = *flow.permeability;
  layer.lower = line.where(0);
  layer.upper = line.where(1);
  layer.permeability = layer.permeability_of_box / line.slope();
  return flow;
}

/// How much of the change of all pores' volume was in those held at an imposed pressure.
double share_of_held_pores(const SteadyFlow& flow, const Packing& after, Clock& clock) {
  PoreNetwork moved = flow.network;
  follow(moved, after, clock);
  double held = 0, all = 0;
  for (std::size_t i = 0; i < moved.pores.size(); ++i) {
    const double change = moved.pores.void_volume[i] - flow.network.pores.void_volume[i];
    all += change;
    held += flow.system.known(i) ? change : 0;
  }
  return held / all;
}

void measure_compressibility(const Oedometer& test, GrainCycle cycle, const SteadyFlow& flow, Layer& layer,
                             Clock& clock) {
  const Packing before = packing_of(cycle.grains);
  double half = 0;
  for (std::size_t n = 1; n <= load_increments; ++n) {
    const double from = test.load * (n - 1.0) / load_increments, rise = test.load / load_increments;
    const double step = limits_of(cycle).chosen();
    for (std::size_t k = 1; k <= steps_of_an_increment; ++k) {
      const double stress = test.confining_stress + from + rise * static_cast<double>(k) / steps_of_an_increment;
      std::get<LoadedWall>(cycle.scene.walls.motion[index(Face::z_max)]).stress = stress;
      cycle.advance(step, clock);
    }
    relax(cycle, {1e-6, 1e-5}, clock);
    half = n == 1 ? layer.height - height(cycle) : half;
  }
  layer.final_settlement = layer.height - height(cycle);
  layer.nonlinearity = load_increments * half / layer.final_settlement - 1;
  layer.share_of_ends = share_of_held_pores(flow, packing_near(cycle.grains, before), clock);
  layer.compressibility = (1 - layer.share_of_ends) * layer.final_settlement / (layer.drained_length() * test.load);
}

Moment look(const Oedometer& test, const Layer& layer, const Simulation& simulation, double time_factor) {
  const PoreNetwork& network = simulation.fluid()->network();
  const double now = height(simulation.grains());
  std::vector<double> sum(slices, 0.0), volume(slices, 0.0);
  for (std::size_t i = 0; i < network.pores.size(); ++i) {
    const double z = (network.pores.centre[i].z() - network.box.lower.z()) / now;
    const auto slice = static_cast<std::size_t>(std::clamp(z * slices, 0.0, slices - 1.0));
    sum[slice] += network.pores.void_volume[i] * simulation.fluid()->pressure()[i];
    volume[slice] += network.pores.void_volume[i];
  }
  Moment moment{time_factor, (layer.height - now) / layer.final_settlement, 0, {}};
  for (std::size_t s = 0; s < slices; ++s)
    moment.pressure.push_back(sum[s] / volume[s] / test.load);
  moment.middle_pressure =
      (sum[slices / 2 - 1] + sum[slices / 2]) / (volume[slices / 2 - 1] + volume[slices / 2]) / test.load;
  return moment;
}

/// J, in motion and springs.
double stored_energy(const GrainCycle& cycle) {
  return kinetic_energy(cycle.grains, cycle.scene.walls) + elastic_energy(cycle.grains, cycle.contacts);
}

} // namespace

GrainCycle compacted(const Oedometer& test, Clock& clock) {
  const Packing loose = random_packing({.spheres = test.grains,
                                        .solid_fraction = solid_fraction_at_start,
                                        .radius_ratio = test.radius_ratio,
                                        .seed = test.seed,
                                        .size = test.side,
                                        .periodic = sideways});
  GrainCycle cycle(loose, grain_scene(test, test.confining_stress, test.friction_prepared, damping));
  relax(cycle, {}, clock);
  cycle.set_scene(grain_scene(test, test.confining_stress, test.friction, damping));
  relax(cycle, {1e-6}, clock);
  return cycle;
}

Scene under_load(const Oedometer& test, double viscosity) {
  Scene scene;
  scene.grains = grain_scene(test, test.confining_stress + test.load, test.friction, damping_of_test);
  scene.scheme = SemiImplicit{};
  scene.fluid.emplace();
  scene.fluid->fluid.viscosity = viscosity;
  for (const Face face : all_faces)
    if (sideways[index(axis_of(face))])
      scene.fluid->faces[index(face)] = Periodic{};
    else
      scene.fluid->faces[index(face)] = Pressure{0};
  return scene;
}

Consolidation consolidate(const Oedometer& test, const std::vector<double>& time_factors,
                          const std::function<void(const std::string&, double)>& say) {
  Consolidation result;
  Layer& layer = result.layer;
  Clock clock;
  say("compacting", 0);
  const GrainCycle start = compacted(test, clock);
  layer.height = height(start);
  const SteadyFlow flow = measure_permeability(start, layer, clock);
  say("drained step", 0);
  measure_compressibility(test, start, flow, layer, clock);
  layer.viscosity = 1;
  layer.viscosity = layer.time_factor(test.duration);

  Simulation simulation(under_load(test, layer.viscosity), start);
  const double stored = stored_energy(start), began = start.time;
  const EnergyBalance before = start.energy;
  result.contact_limit = simulation.limits().contact;
  result.step = simulation.step();
  for (const double wanted : time_factors) {
    double now = 0;
    while (now < wanted) {
      simulation.advance();
      now = layer.time_factor(simulation.grains().time - began);
      if (simulation.steps() % 50 == 0)
        say("consolidating", now / time_factors.back());
    }
    result.moments.push_back(look(test, layer, simulation, now));
  }
  const EnergyBalance& after = simulation.grains().energy;
  const double work = after.loads - before.loads;
  result.energy_error = (work - (after.lost() - before.lost()) - (stored_energy(simulation.grains()) - stored)) / work;
  result.steps = simulation.steps();
  result.stages = simulation.clock().stages();
  return result;
}

} // namespace studies
