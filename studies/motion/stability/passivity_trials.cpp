#include "studies/motion/stability/passivity_trials.hpp"

#include "pfv/problem/generate.hpp"
#include "pfv/simulation/drained_box.hpp"
#include "pfv/simulation/energy_account.hpp"
#include "pfv/simulation/resistance.hpp"
#include "studies/motion/stability/original_motion.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace studies {

using namespace pfv;

namespace {

constexpr std::array ratios{1.0, 5.0, 20.0};

Packing packing_of_ratio(double ratio) {
  return random_packing({.spheres = 60, .solid_fraction = 0.5, .radius_ratio = ratio, .seed = 3});
}

Measured resisting(double ratio) {
  Clock clock;
  const PoreNetwork network = build_pore_network(packing_of_ratio(ratio), {}, clock);
  const FlowSystem system =
      assemble(network, conductances(network, HydraulicRadius{}, MirrorWalls{}, 1), flow_along(Axis::z, 0.0));
  const SolidFlux flux = solid_flux(network, MirrorWalls{});
  const Passivity found = passivity(resistance(system, flux, flux));
  return {{{"smallest / largest eigenvalue", found.least, -1e-10}, {"asymmetry", found.asymmetry, 0, 1e-9}},
          {},
          {ratio, found.least, found.asymmetry}};
}

Theirs theirs_resisting(double ratio) {
  const OriginalResistance answer = original_resistance(packing_of_ratio(ratio));
  if (!answer.matrix)
    return {answer.why_not};
  const Passivity found = passivity(*answer.matrix);
  return {fmt::format("{}smallest / largest eigenvalue {:.2g}, asymmetry {:.2g}",
                      found.asymmetry > 1e-3 ? "asymmetric: " : "", found.least, found.asymmetry),
          {ratio, found.least, found.asymmetry}};
}

/// A run at a tenth of the step that would be taken, so that its own error is below what is looked for.
Measured balanced(double ratio) {
  Scene scene = drained_box(150, ratio, 10);
  scene.grains.damping.share = 0.1;
  scene.step = 0.1 * Simulation(scene).step();
  Simulation simulation(scene);
  EnergyAccount account(simulation);
  double before = 0, least = 0, most = 0;
  for (int n = 0; n < 4000; ++n) {
    account.advance();
    const double taken = simulation.grains().energy.fluid;
    least = std::min(least, taken - before);
    most = std::max(most, taken - before);
    before = taken;
  }
  const double missing = account.accounted() - 1;
  return {{{"energy balance misses", missing, -1e-3, 1e-3},
           {"taken by the fluid / work of the load", before / simulation.grains().energy.loads, 0, 1},
           {"least taken in a step / most", least / most, -1e-9}},
          {},
          {ratio, std::abs(missing)}};
}

} // namespace

std::vector<Trial> resistance_trials() {
  std::vector<Trial> trials;
  for (const double ratio : ratios)
    trials.push_back({"Resistance to motion", fmt::format("size ratio {:g}", ratio), true,
                      [=] { return resisting(ratio); }, [=] { return theirs_resisting(ratio); }});
  return trials;
}

std::vector<Trial> energy_trials() {
  std::vector<Trial> trials;
  for (const double ratio : ratios)
    trials.push_back({"Energy of a coupled run", fmt::format("size ratio {:g}", ratio), ratio == 5,
                      [=] { return balanced(ratio); }});
  return trials;
}

} // namespace studies
