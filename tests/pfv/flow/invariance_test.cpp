// The answer does not depend on where the packing is, how it is turned, numbered or measured.
#include "support/packings.hpp"

#include <algorithm>
#include <gtest/gtest.h>
#include <random>

using namespace pfv;
using namespace pfv::testing;

namespace {

constexpr double same = 3e-9; // fluxes that balance to this are taken for the answer

class Invariance : public ::testing::TestWithParam<const char*> {
protected:
  const Packing packing = packing_from(GetParam());
  const double k = *solved(flow_through(packing)).permeability;
};

TEST_P(Invariance, UnderTranslation) {
  Packing moved = packing;
  const Vec3 shift(3.25, -7.5, 0.3);
  moved.box.lower += shift;
  moved.box.upper += shift;
  for (auto& sphere : moved.spheres)
    sphere.centre += shift;
  EXPECT_NEAR(*solved(flow_through(moved)).permeability / k, 1, same);
}

TEST_P(Invariance, UnderQuarterTurns) { // z -> x -> y -> z, and a quarter turn about z
  Packing turned = packing, spun = packing;
  const auto cycle = [](const Vec3& v) { return Vec3(v.z(), v.x(), v.y()); };
  turned.box = {cycle(packing.box.lower), cycle(packing.box.upper)};
  for (auto& sphere : turned.spheres)
    sphere.centre = cycle(sphere.centre);
  EXPECT_NEAR(*solved(flow_through(turned, Axis::x)).permeability / k, 1, same);
  for (auto& sphere : spun.spheres)
    sphere.centre = Vec3(1 - sphere.centre.y(), sphere.centre.x(), sphere.centre.z());
  EXPECT_NEAR(*solved(flow_through(spun)).permeability / k, 1, same);
}

TEST_P(Invariance, UnderRenumbering) {
  Packing shuffled = packing;
  std::ranges::shuffle(shuffled.spheres, std::mt19937_64(5));
  EXPECT_NEAR(*solved(flow_through(shuffled)).permeability / k, 1, same);
}

TEST_P(Invariance, UnderAChangeOfLengthUnit) {
  Packing scaled = packing;
  scaled.box = {1e-3 * packing.box.lower, 1e-3 * packing.box.upper};
  for (auto& sphere : scaled.spheres)
    sphere = {1e-3 * sphere.centre, 1e-3 * sphere.radius};
  const auto flow = solved(flow_through(scaled));
  EXPECT_NEAR(*flow.permeability / (1e-6 * k), 1, same);
  EXPECT_NEAR(force_on_spheres(flow).z(), -1e-6, 1e-15);
}

TEST_P(Invariance, UnderViscosityAndPressureDrop) {
  Case problem = flow_through(packing);
  problem.fluid.viscosity = 1e-3;
  problem.faces = flow_along(Axis::z, -250);
  const auto flow = solved(problem);
  EXPECT_NEAR(*flow.permeability / k, 1, same);
  EXPECT_NEAR(force_on_spheres(flow).z(), 250, 1e-7);
}

INSTANTIATE_TEST_SUITE_P(Packings, Invariance, ::testing::Values("bcc9.txt", "bcc9jit.txt", "g200.txt", "g2000.txt"));

} // namespace
