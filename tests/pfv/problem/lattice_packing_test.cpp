#include "pfv/problem/error.hpp"
#include "pfv/problem/generate.hpp"
#include "support/message_of.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace pfv {
namespace {

using testing::message_of;

/// The part of a sphere that is in the box when each face it is centred on cuts off half of it.
double part_in_box(const Sphere& sphere, const Box& box) {
  const auto on_lower = (sphere.centre.array() == box.lower.array()).count();
  const auto on_upper = (sphere.centre.array() == box.upper.array()).count();
  return std::pow(0.5, on_lower + on_upper);
}

double solid_fraction_in_box(const Packing& packing) {
  double volume = 0;
  for (const Sphere& sphere : packing.spheres)
    volume += part_in_box(sphere, packing.box) * 4 * std::numbers::pi / 3 * std::pow(sphere.radius, 3);
  return volume / packing.box.volume();
}

double smallest_gap(const Packing& packing) {
  double gap = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < packing.spheres.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const auto& [a, r_a] = packing.spheres[i];
      const auto& [b, r_b] = packing.spheres[j];
      gap = std::min(gap, (a - b).norm() - r_a - r_b);
    }
  return gap;
}

class LatticePacking : public ::testing::TestWithParam<Lattice> {};
INSTANTIATE_TEST_SUITE_P(All, LatticePacking, ::testing::Values(Lattice::simple_cubic, Lattice::bcc, Lattice::fcc));

TEST_P(LatticePacking, FillsTheBoxToTheSolidFractionAsked) {
  for (const double part : {0.001, 0.5, 1.0})
    for (const int cells : {1, 2, 3}) {
      const double asked = part * touching_solid_fraction(GetParam());
      const Packing packing = lattice_packing(GetParam(), asked, cells, 0.01);
      EXPECT_NEAR(solid_fraction_in_box(packing), asked, 1e-13) << cells;
      EXPECT_EQ(packing.box.upper, Vec3::Constant(cells * 0.01));
      EXPECT_NO_THROW(validate(packing));
    }
}

TEST_P(LatticePacking, TouchesAtTheTouchingFractionAndNotBelow) {
  const double touching = touching_solid_fraction(GetParam());
  EXPECT_NEAR(smallest_gap(lattice_packing(GetParam(), touching, 2)), 0, 1e-15);
  EXPECT_GT(smallest_gap(lattice_packing(GetParam(), 0.999 * touching, 2)), 1e-4);
  EXPECT_EQ(lattice_packing(GetParam(), touching * (1 + 1e-12), 2), lattice_packing(GetParam(), touching, 2));
}

TEST_P(LatticePacking, RefusesParametersOutOfRange) {
  const auto complaint = [](double fraction, int cells, double size) {
    return message_of<InputError>([=] { lattice_packing(GetParam(), fraction, cells, size); });
  };
  const double touching = touching_solid_fraction(GetParam());
  for (const double fraction : {0.0, -0.1, touching * (1 + 1e-11), std::nan("")})
    EXPECT_TRUE(complaint(fraction, 1, 1).starts_with("solid_fraction \"")) << fraction;
  EXPECT_EQ(complaint(0.1, 0, 1), "cells \"0\" must be 1 or more");
  for (const double size : {0.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity()})
    EXPECT_TRUE(complaint(0.1, 1, size).starts_with("cell_size \"")) << size;
}

TEST(LatticePackingCounts, EverySphereOnce) {
  for (const std::size_t n : {1, 2, 4}) {
    const auto count = [&](Lattice lattice) {
      return lattice_packing(lattice, 0.1, static_cast<int>(n)).spheres.size();
    };
    EXPECT_EQ(count(Lattice::simple_cubic), n * n * n);
    EXPECT_EQ(count(Lattice::bcc), (n + 1) * (n + 1) * (n + 1) + n * n * n);
    EXPECT_EQ(count(Lattice::fcc), (n + 1) * (n + 1) * (n + 1) + 3 * n * n * (n + 1));
  }
}

TEST(LatticePackingCounts, TouchingSimpleCubicSpheresEndOnTheWalls) {
  for (const Sphere& sphere : lattice_packing(Lattice::simple_cubic, std::numbers::pi / 6, 1).spheres) {
    EXPECT_EQ(sphere.centre, Vec3::Constant(0.5));
    EXPECT_EQ(sphere.radius, 0.5);
  }
}

TEST(NineSpheres, CornerSpheresTouchThreeWallsAndTheMiddleOne) {
  for (const double size : {1.0, 3e-3}) {
    const Packing packing = nine_spheres(size);
    ASSERT_EQ(packing.spheres.size(), 9U);
    const Sphere& middle = packing.spheres.back();
    EXPECT_EQ(middle.centre, Vec3::Constant(size / 2));
    for (std::size_t i = 0; i < 8; ++i) {
      const auto& [centre, radius] = packing.spheres[i];
      EXPECT_EQ(radius, middle.radius);
      EXPECT_NEAR((centre - middle.centre).norm(), 2 * radius, 1e-15 * size);
      for (int axis = 0; axis < 3; ++axis)
        EXPECT_NEAR(std::min(centre[axis], size - centre[axis]), radius, 1e-16 * size);
    }
    EXPECT_NO_THROW(validate(packing)); // eight different corners
  }
}

TEST(NineSpheres, RefusesSizes) {
  EXPECT_EQ(message_of<InputError>([] { nine_spheres(0); }), "size \"0\" must be a positive number (m)");
  EXPECT_EQ(message_of<InputError>([] { nine_spheres(-1); }), "size \"-1\" must be a positive number (m)");
}

TEST(LatticePacking, HasEachSphereOnceInAPeriodicBox) {
  constexpr PeriodicAxes everywhere{true, true, true};
  for (const int cells : {1, 2, 3})
    for (const auto& [lattice, per_cell] :
         {std::pair{Lattice::simple_cubic, 1}, {Lattice::bcc, 2}, {Lattice::fcc, 4}}) {
      const Packing packing = lattice_packing(lattice, 0.5, cells, 0.1, everywhere);
      EXPECT_EQ(packing.spheres.size(), static_cast<std::size_t>(per_cell * cells * cells * cells));
      EXPECT_NEAR(solid_fraction(packing), 0.5, 1e-12);
      EXPECT_NO_THROW(validate(packing, everywhere));
    }
  EXPECT_EQ(lattice_packing(Lattice::bcc, 0.5, 1, 1, {true, false, false}).spheres.size(), 4u + 1);
}

} // namespace
} // namespace pfv
