#include "pfv/simulation/vertex_flux.hpp"

#include "pfv/flow/steady_flow.hpp"
#include "pfv/problem/error.hpp"
#include "pfv/problem/generate.hpp"
#include "pfv/simulation/resistance.hpp"

#include <gtest/gtest.h>

using namespace pfv;

namespace {

constexpr PeriodicAxes all_around{true, true, true};

/// A box without walls, its pressures held at one point.
struct Periodical {
  PoreNetwork network;
  FlowSystem system;

  explicit Periodical(double ratio) {
    Clock clock;
    const Packing packing = random_packing(
        {.spheres = 60, .solid_fraction = 0.5, .radius_ratio = ratio, .seed = 3, .periodic = all_around});
    network = build_pore_network(packing, all_around, clock);
    FaceConditions faces;
    faces.fill(Periodic{});
    const std::array points{PressurePoint{{0.5, 0.5, 0.5}, 0}};
    system = assemble(network, conductances(network, HydraulicRadius{}, MirrorWalls{}, 1), faces, points);
  }

  /// Smallest over largest eigenvalue of the symmetric part of what the fluid does against motion: forces by SolidFlux
  /// of the pressures that these rates of volume raise.
  double least_resistance(const SolidFlux& rates) const {
    return passivity(resistance(system, rates, solid_flux(network, MirrorWalls{}))).least;
  }
};

TEST(VertexFlux, IsZeroWhenEverythingMovesTogether) {
  const Periodical box(2);
  const SolidFlux flux = vertex_flux(box.network);
  std::vector<double> rate;
  volume_rates(flux, std::vector<Vec3>(flux.bodies, Vec3(1, -2, 3)), rate);
  for (const double of_pore : rate)
    EXPECT_NEAR(of_pore, 0, 1e-13);
}

TEST(VertexFlux, LetsGrainsOfDifferentSizesDrawEnergyFromTheFluidWhereFacetsDoNot) {
  const Periodical box(5);
  EXPECT_GT(box.least_resistance(solid_flux(box.network, MirrorWalls{})), -1e-10);
  EXPECT_LT(box.least_resistance(vertex_flux(box.network)), -1e-4);
}

TEST(VertexFlux, IsForBoxesWithoutWalls) {
  Clock clock;
  const PoreNetwork network = build_pore_network(random_packing({.spheres = 20, .solid_fraction = 0.4}), {}, clock);
  EXPECT_THROW(vertex_flux(network), InputError);
}

} // namespace
