#include "studies/motion/immersed_settling.hpp"

#include "pfv/flow/steady_flow.hpp"
#include "pfv/problem/generate.hpp"
#include "studies/motion/line_fit.hpp"

#include <algorithm>
#include <cmath>

namespace studies {

using namespace pfv;

namespace {

constexpr double water_below = 0.06, water_above = 0.06; // of the side
constexpr double at_rest = 0.02;                         // of the weight, carried by the fluid

/// Excess pressure at the floor: the mean over the pores on it, by area.
double floor_pressure(const PoreFluid& fluid) {
  double force = 0, area = 0;
  for (const auto& part : fluid.network().wall_parts)
    if (part.face == Face::z_min) {
      force += part.area * fluid.pressure()[part.pore];
      area += part.area;
    }
  return force / area;
}

double mean_speed(const Grains& grains) {
  double sum = 0, mass = 0;
  for (std::size_t i = 0; i < grains.size(); ++i) {
    sum -= grains.mass[i] * grains.velocity[i].translation.z();
    mass += grains.mass[i];
  }
  return sum / mass;
}

SettlingMoment look(const Bed& bed, const Simulation& simulation, double height_at_start) {
  const Grains& grains = simulation.grains().grains;
  const double weight = buoyant_weight(bed, grains);
  return {simulation.grains().time,
          floor_pressure(*simulation.fluid()) * bed.side * bed.side / weight,
          on_floor(simulation.grains()) / weight,
          lift(simulation) / weight,
          mean_height(grains) / height_at_start,
          mean_speed(grains)};
}

/// Of the pores between a fifth and three fifths of the height that holds nine tenths of the grains.
double porosity_of_bed(const Simulation& simulation) {
  const Grains& grains = simulation.grains().grains;
  std::vector<double> heights;
  for (const Sphere& sphere : grains.packing.spheres)
    heights.push_back(sphere.centre.z());
  std::ranges::sort(heights);
  const double top = heights[heights.size() * 9 / 10];
  const PoreNetwork& network = simulation.fluid()->network();
  double hollow = 0, all = 0;
  for (std::size_t i = 0; i < network.pores.size(); ++i)
    if (const double z = network.pores.centre[i].z(); z > 0.2 * top && z < 0.6 * top) {
      hollow += network.pores.void_volume[i];
      all += network.pores.volume[i];
    }
  return hollow / all;
}

} // namespace

Settling settle(const Bed& bed, double solid_fraction, const Say& say) {
  Settling result;
  result.bed = bed;
  result.solid_fraction = solid_fraction;
  Scene scene;
  scene.grains = bed_grains(bed, 0);
  scene.packing = random_packing({.spheres = bed.grains,
                                  .solid_fraction = solid_fraction,
                                  .radius_ratio = bed.radius_ratio,
                                  .seed = bed.seed,
                                  .size = bed.side,
                                  .periodic = scene.grains.walls.periodic});
  scene.fluid = bed_fluid(bed, SlipWall{});
  scene.scheme = SemiImplicit{};

  Case through;
  through.packing = scene.packing;
  through.faces = flow_along(Axis::z, 1.0, scene.grains.walls.periodic, through.packing.box);
  Clock clock;
  result.permeability = *solve_steady_flow(through, {}, clock).permeability;
  result.expected_speed =
      result.permeability * solid_fraction * (bed.density - bed.fluid_density) * bed.gravity / bed.viscosity;

  // Some water above and below: at the start the fluid alone carries the grains. Much of it would let the suspension
  // fall through in drops.
  scene.packing.box.lower.z() -= water_below * bed.side;
  scene.packing.box.upper.z() += water_above * bed.side;
  Simulation simulation(scene);
  const double height_at_start = mean_height(simulation.grains().grains);
  // The topmost grain has some half of the height to fall; films between grains take longer to close.
  const double all = 3 * bed.side / result.expected_speed;
  constexpr int looks = 300;
  for (int n = 0; n <= looks; ++n) {
    do {
      simulation.advance();
      if (simulation.steps() % 50 == 0)
        say("settling", simulation.grains().time / all);
    } while (simulation.grains().time < all * n / looks);
    result.moments.push_back(look(bed, simulation, height_at_start));
    if (n > looks / 10 && result.moments.back().floor_pressure < at_rest)
      break;
  }
  result.bed_porosity = porosity_of_bed(simulation);
  result.steps = simulation.steps();
  result.rebuilt = simulation.fluid()->rebuilt;
  result.stages = simulation.clock().stages();
  return result;
}

ExperimentReport run_immersed_settling(bool quick, const Say& say) {
  Bed bed;
  bed.grains = quick ? 250 : 1000;
  bed.lubricated = true;
  return settling_report(settle(bed, 0.35, say));
}

} // namespace studies
