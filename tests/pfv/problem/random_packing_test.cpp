#include "pfv/problem/case.hpp"
#include "pfv/problem/error.hpp"
#include "pfv/problem/generate.hpp"
#include "support/message_of.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pfv {
namespace {

using testing::message_of;

std::string digest_of(const Packing& packing) {
  return digest({"", packing, {}, flow_along(Axis::z), std::nullopt});
}

/// No overlap between any two spheres or with a wall, compared without a tolerance.
void expect_apart(const Packing& packing) {
  const auto& [box, spheres] = packing;
  for (std::size_t i = 0; i < spheres.size(); ++i) {
    EXPECT_TRUE((spheres[i].centre.array() - spheres[i].radius >= box.lower.array()).all()) << i;
    EXPECT_TRUE((spheres[i].centre.array() + spheres[i].radius <= box.upper.array()).all()) << i;
    for (std::size_t j = 0; j < i; ++j)
      ASSERT_GE((spheres[i].centre - spheres[j].centre).norm(), spheres[i].radius + spheres[j].radius) << i << ' ' << j;
  }
}

class RandomPackings : public ::testing::TestWithParam<RandomPacking> {};

TEST_P(RandomPackings, AreWhatWasAskedWithoutOverlap) {
  const RandomPacking& asked = GetParam();
  const Packing packing = random_packing(asked);
  ASSERT_EQ(packing.spheres.size(), static_cast<std::size_t>(asked.spheres));
  EXPECT_EQ(packing.box, (Box{Vec3::Zero(), Vec3::Constant(asked.size)}));
  EXPECT_NEAR(solid_fraction(packing), asked.solid_fraction, 1e-12 * asked.solid_fraction);
  if (asked.spheres > 1) {
    const auto [smallest, largest] = std::ranges::minmax(packing.spheres, {}, &Sphere::radius);
    EXPECT_NEAR(largest.radius / smallest.radius, asked.radius_ratio, 1e-12 * asked.radius_ratio);
  }
  expect_apart(packing);
  EXPECT_NO_THROW(validate(packing));
}

INSTANTIATE_TEST_SUITE_P(Sweep, RandomPackings,
                         ::testing::Values(RandomPacking{1, 0.5, 1, 1, 1}, RandomPacking{2, 0.05, 20, 1, 1},
                                           RandomPacking{8, 0.5, 1, 1, 1}, RandomPacking{30, 0.48, 1, 1, 1},
                                           RandomPacking{30, 0.4, 1, 2, 1e-3}, RandomPacking{30, 0.45, 3, 3, 250},
                                           RandomPacking{100, 1e-6, 5, 1, 1}, RandomPacking{200, 0.52, 1.3, 1, 1},
                                           RandomPacking{300, 0.4, 20, 1, 0.1}, RandomPacking{600, 0.52, 1, 1, 1}));

TEST(RandomPackingRadii, AreUniformlySpread) {
  Packing packing = random_packing({101, 0.3, 3, 1, 1});
  std::ranges::sort(packing.spheres, {}, &Sphere::radius);
  const double smallest = packing.spheres.front().radius;
  for (int i = 0; i <= 100; ++i)
    EXPECT_NEAR(packing.spheres[i].radius / smallest, 1 + 0.02 * i, 1e-12);
}

TEST(RandomPackingCentres, FillTheBoxEvenly) {
  const Packing packing = random_packing({1000, 0.3, 1, 1, 1});
  Vec3 mean = Vec3::Zero(), mean_square = Vec3::Zero();
  for (const Sphere& sphere : packing.spheres) {
    mean += sphere.centre / 1000;
    mean_square += (sphere.centre - Vec3::Constant(0.5)).cwiseAbs2() / 1000;
  }
  // Standard error of the mean of 1000 free points is 0.009; of their variance, 1/12, 0.0024.
  EXPECT_LT((mean - Vec3::Constant(0.5)).cwiseAbs().maxCoeff(), 0.03);
  EXPECT_LT((mean_square - Vec3::Constant(1 / 12.0)).cwiseAbs().maxCoeff(), 0.01);
}

TEST(RandomPackingGaps, AreOpenWhereThereIsRoom) {
  const Packing packing = random_packing({200, 0.4, 1, 1, 1});
  double smallest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < packing.spheres.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      smallest = std::min(smallest, (packing.spheres[i].centre - packing.spheres[j].centre).norm());
  EXPECT_GT(smallest, 2 * packing.spheres[0].radius * 1.005);
}

TEST(RandomPackingSeed, GivesTheSamePackingOnEveryMachine) {
  // Copied from a run that was the same to the last bit at -O0 and -O3, with and without AVX and fused multiply-adds.
  EXPECT_EQ(digest_of(random_packing({30, 0.45, 2, 1, 1})), "e3473fdf3f6a05ebef128c16db417334");
  EXPECT_EQ(digest_of(random_packing({100, 0.5, 1.3, 1, 1})), "0f255664b39a878b32aa57d4cfdcee4c");
  EXPECT_NE(random_packing({30, 0.4, 1, 1, 1}), random_packing({30, 0.4, 1, 2, 1}));
}

TEST(RandomPackingPeriodic, KeepsApartFromImages) {
  for (const PeriodicAxes periodic : {PeriodicAxes{true, true, true}, PeriodicAxes{true, false, true}})
    for (RandomPacking asked : {RandomPacking{1, 0.5}, RandomPacking{2, 0.4}, RandomPacking{30, 0.5, 2},
                                RandomPacking{200, 0.55, 1, 3, 0.01}}) {
      asked.periodic = periodic;
      const Packing packing = random_packing(asked);
      EXPECT_NEAR(solid_fraction(packing), asked.solid_fraction, 1e-12);
      EXPECT_NO_THROW(validate(packing, periodic));
      EXPECT_EQ(packing, random_packing(asked));
      double closest = std::numeric_limits<double>::infinity();
      int across = 0;
      for (std::size_t i = 0; i < packing.spheres.size(); ++i) {
        const Sphere& one = packing.spheres[i];
        across += one.centre.x() + one.radius > asked.size;
        EXPECT_EQ(periodic[1] || one.centre.y() + one.radius <= asked.size, true);
        for (std::size_t j = 0; j <= i; ++j)
          for (int image = 0; image < 27; ++image) {
            const Vec3 shift(image % 3 - 1, image / 3 % 3 - 1, image / 9 - 1);
            if ((i == j && image == 13) || (!periodic[1] && shift.y() != 0))
              continue;
            const Sphere& other = packing.spheres[j];
            closest =
                std::min(closest, (other.centre + asked.size * shift - one.centre).norm() - one.radius - other.radius);
          }
      }
      EXPECT_GE(closest, -1e-15 * asked.size);
      EXPECT_TRUE(asked.spheres < 30 || across > 0) << "no wall keeps them off";
    }
}

TEST(RandomPackingPeriodic, IsTheSameOnEveryMachine) {
  // Copied from a run that was the same at -O0 and -O3 with AVX2 and fused multiply-adds.
  RandomPacking small{30, 0.45, 2, 1, 1}, larger{100, 0.5, 1.3, 1, 1};
  small.periodic = larger.periodic = {true, false, true};
  EXPECT_EQ(digest_of(random_packing(small)), "1df23c60aec771117e0e9262ea7b5cf1");
  EXPECT_EQ(digest_of(random_packing(larger)), "6e2620974a722d29ecd2380a46f5ee0d");
}

TEST(RandomPackingPeriodic, DoesNotFitASphereLargerThanItsBox) {
  RandomPacking asked{1, 0.55};
  asked.periodic = {true, true, true};
  EXPECT_EQ(message_of<SolveError>([&] { random_packing(asked); }),
            "solid_fraction \"0.55\" was not reached by \"1\" spheres: the search jams at 0.5236");
}

TEST(RandomPackingSize, OnlyScales) {
  const Packing unit = random_packing({30, 0.4, 2, 5, 1});
  const Packing small = random_packing({30, 0.4, 2, 5, 1e-3});
  for (std::size_t i = 0; i < unit.spheres.size(); ++i) {
    EXPECT_LT((small.spheres[i].centre - 1e-3 * unit.spheres[i].centre).norm(), 1e-18);
    EXPECT_DOUBLE_EQ(small.spheres[i].radius, 1e-3 * unit.spheres[i].radius);
  }
}

TEST(RandomPackingRefuses, WhatDoesNotFitSayingWhatDoes) {
  EXPECT_EQ(message_of<SolveError>([] {
              random_packing({1, 0.55, 1, 1, 1});
            }),
            "solid_fraction \"0.55\" was not reached by \"1\" spheres: the search jams at 0.5236");
  // Two spheres at opposite corners touch at r = 1 / (2 + 2/sqrt(3)): a fraction of 0.2670.
  const std::string message = message_of<SolveError>([] { random_packing({2, 0.3, 1, 1, 1}); });
  EXPECT_NEAR(std::stod(message.substr(message.rfind(' '))), 0.267, 0.005) << message;
}

TEST(RandomPackingRefuses, ParametersOutOfRange) {
  const auto complaint = [](const RandomPacking& parameters) {
    return message_of<InputError>([&] { random_packing(parameters); });
  };
  EXPECT_EQ(complaint({0, 0.5, 1, 1, 1}), "spheres \"0\" must be 1 or more");
  EXPECT_EQ(complaint({30, 0, 1, 1, 1}), "solid_fraction \"0\" must be above 0 and at most 0.6");
  EXPECT_EQ(complaint({30, 0.61, 1, 1, 1}), "solid_fraction \"0.61\" must be above 0 and at most 0.6");
  EXPECT_EQ(complaint({30, std::nan(""), 1, 1, 1}), "solid_fraction \"nan\" must be above 0 and at most 0.6");
  EXPECT_EQ(complaint({30, 0.5, 0.5, 1, 1}), "radius_ratio \"0.5\" must be a number, 1 or more");
  EXPECT_EQ(complaint({30, 0.5, std::nan(""), 1, 1}), "radius_ratio \"nan\" must be a number, 1 or more");
  EXPECT_EQ(complaint({30, 0.5, 1, 1, -1}), "size \"-1\" must be a positive number (m)");
  EXPECT_EQ(complaint({30, 0.5, 1, 1, std::nan("")}), "size \"nan\" must be a positive number (m)");
}

} // namespace
} // namespace pfv
