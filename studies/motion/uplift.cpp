#include "studies/motion/uplift.hpp"

#include "pfv/problem/generate.hpp"
#include "pfv/simulation/relax.hpp"
#include "studies/motion/line_fit.hpp"

#include <algorithm>

namespace studies {

using namespace pfv;

namespace {

constexpr double solid_fraction_at_start = 0.35;
constexpr double highest = 1.2; // of the pressure below that balances the weight

GrainCycle bed_at_rest(const Bed& bed, Clock& clock) {
  const GrainScene scene = bed_grains(bed, 0.2);
  const Packing loose = random_packing({.spheres = bed.grains,
                                        .solid_fraction = solid_fraction_at_start,
                                        .radius_ratio = bed.radius_ratio,
                                        .seed = bed.seed,
                                        .size = bed.side,
                                        .periodic = scene.walls.periodic});
  GrainCycle cycle(loose, scene);
  relax(cycle, {1e-4}, clock);
  return cycle;
}

double top_of(const Grains& grains) {
  std::vector<double> heights;
  for (const Sphere& sphere : grains.packing.spheres)
    heights.push_back(sphere.centre.z());
  std::ranges::sort(heights);
  return heights[heights.size() * 9 / 10];
}

/// Of the pores in the middle of the bed: their excess pressure over height, and how hollow it is.
struct Middle {
  LineFit pressure;
  double hollow = 0, all = 0;
};

Middle middle_of(const PoreFluid& fluid, double top) {
  Middle middle;
  const PoreNetwork& network = fluid.network();
  for (std::size_t i = 0; i < network.pores.size(); ++i)
    if (const double z = network.pores.centre[i].z(); z > 0.2 * top && z < 0.8 * top) {
      middle.pressure.add(z, fluid.pressure()[i], network.pores.void_volume[i]);
      middle.hollow += network.pores.void_volume[i];
      middle.all += network.pores.volume[i];
    }
  return middle;
}

/// The gradient at which `value` first passes `level`, between moments.
double passes_at(const std::vector<UpliftMoment>& moments, double UpliftMoment::*value, double level) {
  for (std::size_t k = 1; k < moments.size(); ++k) {
    const double a = moments[k - 1].*value - level, b = moments[k].*value - level;
    if (a * b <= 0 && a != b)
      return moments[k - 1].gradient + (moments[k].gradient - moments[k - 1].gradient) * a / (a - b);
  }
  return 0;
}

} // namespace

Uplift lift_up(const Bed& bed, const Say& say) {
  Uplift result;
  result.bed = bed;
  Clock clock;
  say("settling the bed", 0);
  GrainCycle rest = bed_at_rest(bed, clock);
  result.height = top_of(rest.grains);
  const double weight = buoyant_weight(bed, rest.grains), balance = weight / (bed.side * bed.side);
  double diameter = 0;
  for (const Sphere& sphere : rest.grains.packing.spheres)
    diameter += 2 * sphere.radius / bed.grains;
  const double height_before = mean_height(rest.grains);

  Scene scene;
  scene.grains = bed_grains(bed, 0);
  scene.fluid = bed_fluid(bed, Pressure{0});
  scene.scheme = SemiImplicit{};
  constexpr double duration = 2; // s: long against the tenths in which the pressures of the bed even out
  const double began = rest.time;
  scene.fluid->in_time[index(Face::z_min)] = {{{began, 0}, {began + duration, highest * balance}}};
  Simulation simulation(scene, std::move(rest));
  const Middle before = middle_of(*simulation.fluid(), result.height);
  result.porosity = before.hollow / before.all;
  result.critical = (1 - result.porosity) * (bed.density / bed.fluid_density - 1);

  constexpr int looks = 200;
  for (int n = 1; n <= looks; ++n) {
    double done = 0;
    do {
      done = (simulation.grains().time - began) / duration;
      simulation.advance();
      if (simulation.steps() % 50 == 0)
        say("raising the pressure", done);
    } while (done < static_cast<double>(n) / looks);
    const Middle now = middle_of(*simulation.fluid(), result.height);
    result.moments.push_back({-now.pressure.slope() / (bed.fluid_density * bed.gravity),
                              on_floor(simulation.grains()) / weight, lift(simulation) / weight,
                              (mean_height(simulation.grains().grains) - height_before) / diameter});
    if (result.moments.back().rise > 0.1)
      break;
  }
  result.carried_at = passes_at(result.moments, &UpliftMoment::lift, 1);
  result.risen_at = passes_at(result.moments, &UpliftMoment::rise, 0.01);
  result.steps = simulation.steps();
  result.stages = simulation.clock().stages();
  return result;
}

ExperimentReport run_uplift(bool quick, const Say& say) {
  Bed bed;
  bed.grains = quick ? 1500 : 2000;
  return uplift_report(lift_up(bed, say));
}

} // namespace studies
