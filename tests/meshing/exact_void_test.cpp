#include "meshing/exact_void.hpp"

#include "pfv/problem/generate.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <random>

namespace {

using meshing::exact_void;
using std::numbers::pi;

constexpr double tolerance = 1e-9;

double ball(double r) {
  return 4 * pi / 3 * r * r * r;
}
double sphere(double r) {
  return 4 * pi * r * r;
}
double cap(double r, double height) {
  return pi * height * height * (3 * r - height) / 3;
}

pfv::Packing packing_of(std::vector<pfv::Sphere> spheres) {
  pfv::Packing packing;
  packing.box = {{-0.5, 0, 0}, {1.5, 1, 1}};
  packing.spheres = std::move(spheres);
  return packing;
}

TEST(ExactVoid, WholeSphereTouchingFourFaces) {
  const auto [volume, surface] = exact_void(packing_of({{{0.5, 0.5, 0.5}, 0.5}}));
  EXPECT_NEAR(volume, 2 - ball(0.5), tolerance);
  EXPECT_NEAR(surface, sphere(0.5), tolerance);
}

TEST(ExactVoid, HalfQuarterAndEighthOfASphere) {
  const pfv::Vec3 face(0.3, 0, 0.5), edge(0.3, 1, 0), corner(-0.5, 1, 0);
  double share = 2;
  for (const pfv::Vec3& centre : {face, edge, corner}) {
    const auto [volume, surface] = exact_void(packing_of({{centre, 0.4}}));
    EXPECT_NEAR(volume, 2 - ball(0.4) / share, tolerance);
    EXPECT_NEAR(surface, sphere(0.4) / share, tolerance);
    share *= 2;
  }
}

TEST(ExactVoid, CapsCutOffByEveryFace) {
  for (int axis = 0; axis < 3; ++axis)
    for (const bool upper : {false, true}) {
      auto packing = packing_of({{{0.5, 0.5, 0.5}, 0.3}});
      (upper ? packing.box.upper : packing.box.lower)[axis] = upper ? 0.7 : 0.3;
      const auto [volume, surface] = exact_void(packing);
      EXPECT_NEAR(volume, packing.box.volume() - ball(0.3) + cap(0.3, 0.1), tolerance);
      EXPECT_NEAR(surface, sphere(0.3) - 2 * pi * 0.3 * 0.1, tolerance);
    }
}

TEST(ExactVoid, LensOfTwoSpheresIsCountedOnce) {
  const double r = 0.3, distance = 0.4;
  const auto [volume, surface] = exact_void(packing_of({{{0.3, 0.5, 0.5}, r}, {{0.3 + distance, 0.5, 0.5}, r}}));
  EXPECT_NEAR(volume, 2 - 2 * ball(r) + 2 * cap(r, r - distance / 2), tolerance);
  EXPECT_NEAR(surface, 2 * sphere(r) - 2 * 2 * pi * r * (r - distance / 2), tolerance);
}

TEST(ExactVoid, ASphereInsideAnotherDoesNotCount) {
  const auto [volume, surface] = exact_void(packing_of({{{0.5, 0.5, 0.5}, 0.3}, {{0.55, 0.5, 0.45}, 0.1}}));
  EXPECT_NEAR(volume, 2 - ball(0.3), tolerance);
  EXPECT_NEAR(surface, sphere(0.3), tolerance);
}

TEST(ExactVoid, LatticesCutByTheirPlanesOfSymmetryHaveTheirPorosity) {
  for (const auto lattice : {pfv::Lattice::simple_cubic, pfv::Lattice::bcc, pfv::Lattice::fcc}) {
    const double fraction = pfv::touching_solid_fraction(lattice);
    EXPECT_NEAR(exact_void(pfv::lattice_packing(lattice, fraction, 2)).volume, 8 * (1 - fraction), 8 * tolerance);
  }
}

// Slices are always across x, so any mistake in them shows when the axes are exchanged.
TEST(ExactVoid, IsTheSameAlongEveryAxis) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> position(0, 1), radius(0.15, 0.4);
  for (int draw = 0; draw < 2; ++draw) {
    pfv::Packing packing;
    for (int k = 0; k < 8; ++k)
      packing.spheres.push_back({{position(random), position(random), position(random)}, radius(random)});
    const auto expected = exact_void(packing);
    for (int turn = 0; turn < 2; ++turn) {
      for (auto& [centre, r] : packing.spheres)
        centre = pfv::Vec3(centre.y(), centre.z(), centre.x());
      const auto found = exact_void(packing);
      EXPECT_NEAR(found.volume, expected.volume, tolerance);
      EXPECT_NEAR(found.surface, expected.surface, 100 * tolerance);
    }
  }
}

TEST(ExactVoid, SurfaceIsTheDerivativeOfVolume) {
  // Three spheres that overlap each other and a face: d volume / d r = - surface when all radii grow together.
  const auto grown = [](double by) {
    return exact_void(
        packing_of({{{0.3, 0.3, 0.1}, 0.25 + by}, {{0.6, 0.4, 0.2}, 0.21 + by}, {{0.4, 0.6, 0.2}, 0.22 + by}}));
  };
  const double step = 1e-4;
  EXPECT_NEAR((grown(-step).volume - grown(step).volume) / (2 * step), grown(0).surface, 1e-6);
}

TEST(ExactVoid, ScalesWithLength) {
  auto packing = packing_of({{{0.3, 0.3, 0.1}, 0.25}, {{0.6, 0.4, 0.2}, 0.2}});
  const auto metres = exact_void(packing);
  packing.box = {1e-3 * packing.box.lower, 1e-3 * packing.box.upper};
  for (auto& [centre, radius] : packing.spheres) {
    centre *= 1e-3;
    radius *= 1e-3;
  }
  EXPECT_NEAR(exact_void(packing).volume / 1e-9, metres.volume, tolerance);
  EXPECT_NEAR(exact_void(packing).surface / 1e-6, metres.surface, tolerance);
}

} // namespace
