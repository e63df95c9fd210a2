// Spheres that share points by threes and more, and overlap their mirror images: sums are still those of the union.
#include "pfv/problem/generate.hpp"
#include "support/packings.hpp"

#include <algorithm>
#include <gtest/gtest.h>
#include <numeric>

using namespace pfv;
using pfv::testing::network_of;

namespace {

Packing grown(Packing packing, double by) {
  for (auto& sphere : packing.spheres)
    sphere.radius += by;
  return packing;
}

Packing random(double ratio) {
  return random_packing({.spheres = 60, .solid_fraction = .45, .radius_ratio = ratio, .seed = 3});
}

Packing cut_by_walls() {
  Packing packing = random(2);
  packing.box = {Vec3::Constant(.2), Vec3::Constant(.8)};
  std::erase_if(packing.spheres, [&](const Sphere& sphere) {
    return (sphere.centre.array() < .2).any() || (sphere.centre.array() > .8).any();
  });
  return packing;
}

double counted_porosity(const Packing& packing) {
  constexpr int n = 40;
  int outside = 0;
  for (int i = 0; i < n * n * n; ++i) {
    const Vec3 share = (Vec3(i % n, i / n % n, i / n / n) + Vec3::Constant(.5)) / n;
    const Vec3 at = packing.box.lower + share.cwiseProduct(packing.box.size());
    outside += std::ranges::none_of(packing.spheres, [&](const Sphere& sphere) {
      return (sphere.centre - at).squaredNorm() < sphere.radius * sphere.radius;
    });
  }
  return outside / (double(n) * n * n);
}

double wetted(const PoreNetwork& network) {
  return std::accumulate(network.spheres.wetted_surface.begin(), network.spheres.wetted_surface.end(), 0.0);
}

TEST(Union, HasThePorosityThatCountingGives) {
  for (const Packing& packing : {random(1.35), random(5), cut_by_walls()})
    for (const double by : {.02, .05, .1})
      EXPECT_NEAR(network_of(grown(packing, by)).porosity(), counted_porosity(grown(packing, by)), 3e-3) << by;
}

TEST(Union, LosesVoidByItsSurfaceWhenItGrows) { // to the order of the step, whatever closes and flips on the way
  const double step = 1e-6;
  for (const Packing& packing : {random(1.35), random(5), cut_by_walls()})
    for (const double by : {.003, .02, .04, .06, .09, .15}) {
      const double volume = packing.box.volume();
      const double lost =
          network_of(grown(packing, by - step)).porosity() - network_of(grown(packing, by + step)).porosity();
      const double surface = wetted(network_of(grown(packing, by)));
      EXPECT_NEAR(lost * volume / (2 * step), surface, 1e-6 * volume + 1e-5 * surface) << by;
    }
}

TEST(Union, GivesEachSphereASurfaceAndPoresAVoidThatAreNotNegative) {
  for (const Packing& packing : {random(1.35), random(5), cut_by_walls()})
    for (const double by : {.02, .05, .1, .2}) {
      const PoreNetwork network = network_of(grown(packing, by));
      for (const double surface : network.spheres.wetted_surface)
        EXPECT_GE(surface, -1e-12);
      for (const double volume : network.spheres.volume)
        EXPECT_GE(volume, -1e-12);
      for (std::size_t t = 0; t < network.throats.size(); ++t) {
        EXPECT_GE(network.throats.fluid_area[t], 0);
        EXPECT_TRUE(std::isfinite(network.throats.void_volume[t]));
      }
    }
}

TEST(Union, ClosesThroatsAndLeavesTheVoidBetweenThem) { // a cube of spheres whose discs meet in its faces
  const Packing lattice = lattice_packing(Lattice::simple_cubic, touching_solid_fraction(Lattice::simple_cubic), 3);
  const PoreNetwork network = network_of(grown(lattice, .25)); // radius .75
  EXPECT_GT(network.closed_throats, 0u);
  for (std::size_t t = 0; t < network.throats.size(); ++t)
    EXPECT_TRUE(network.throats.fluid_area[t] == 0 || network.throats.length[t] < 1e-9);
  EXPECT_NEAR(network.porosity(), counted_porosity(grown(lattice, .25)), 3e-3);
  EXPECT_NEAR(network_of(grown(lattice, std::sqrt(.75) - .5 + 1e-9)).porosity(), 0, 1e-12); // closed as well
}

} // namespace
