#include "studies/runner/extrapolate.hpp"

#include "pfv/problem/error.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace {

using studies::extrapolate;
using studies::Sample;

Sample on_power_law(double h, double order) {
  return {h, 3 + 0.2 * std::pow(h, order)};
}

TEST(Extrapolate, TwoMeshesOfTheStatedOrderGiveTheExactValue) {
  for (const double order : {1.0, 2.0, 3.5}) {
    const auto k = extrapolate({on_power_law(1.4, order), on_power_law(1.0, order)}, order);
    EXPECT_NEAR(k.value, 3, 1e-13);
    EXPECT_EQ(k.order, order);
    // 1.25 times the distance from the finest value to the one of this order, of 2 where it is higher.
    const double fallen = 0.2 * (std::pow(1.4, order) - 1);
    EXPECT_NEAR(k.error.value(), 1.25 * fallen / (std::pow(1.4, std::min(order, 2.0)) - 1), 1e-13);
  }
}

// A method of order 3.5 on meshes too coarse for it.
TEST(Extrapolate, TwoMeshesThatHaveNotReachedAHighOrderHaveABarForIt) {
  for (const double order : {1.7, 2.0, 2.5, 3.0, 3.5, 4.0}) {
    const auto k = extrapolate({on_power_law(2.0, order), on_power_law(1.4, order)}, 3.5);
    EXPECT_LE(std::abs(k.value - 3), k.error.value()) << order;
  }
}

TEST(Extrapolate, TheOrderOfTheSamplesDoesNotMatter) {
  EXPECT_EQ(extrapolate({{1.0, 5}, {2.0, 7}}, 2), extrapolate({{2.0, 7}, {1.0, 5}}, 2));
}

TEST(Extrapolate, ThreeMeshesOfTheStatedOrderGiveTheExactValueAndAShareOfTheDistance) {
  for (const double order : {1.0, 2.0, 3.5}) {
    const auto k = extrapolate({on_power_law(2.0, order), on_power_law(1.4, order), on_power_law(1.0, order)}, order);
    EXPECT_NEAR(k.value, 3, 1e-13);
    EXPECT_NEAR(k.error.value(), studies::least_share * 0.2, 1e-12);
    EXPECT_EQ(k.order, order);
  }
}

// Where the order is not the stated one the bar must reach the truth, 3: exactly at order 1, with room above.
TEST(Extrapolate, TheBarHoldsTheTruthWhenTheOrderIsAnother) {
  for (const double order : {1.0, 1.3, 1.7, 2.5, 3.0, 4.0}) {
    const auto k = extrapolate({on_power_law(1.4, order), on_power_law(1.0, order), on_power_law(0.7, order)}, 2);
    EXPECT_GT(k.error.value(), 0);
    EXPECT_LE(std::abs(k.value - 3), 1.05 * k.error.value()) << order;
  }
}

TEST(Extrapolate, TheBarGrowsWithTheDistanceFromTheStatedOrder) {
  const auto bar = [](double order) {
    return *extrapolate({on_power_law(2.0, order), on_power_law(1.4, order), on_power_law(1.0, order)}, 2).error;
  };
  EXPECT_GT(bar(1), bar(2));
  EXPECT_GT(bar(3), bar(2));
  EXPECT_GT(bar(4), bar(3));
}

TEST(Extrapolate, TheBarHoldsTheTruthWhenTheOrderIsNotClean) {
  // A second term of higher order, as real meshes have.
  const auto f = [](double h) { return Sample{h, 3 + 0.2 * h * h + 0.05 * h * h * h}; };
  for (const auto& samples : {std::vector{f(1.4), f(1.0)}, std::vector{f(2.0), f(1.4), f(1.0)}}) {
    const auto k = extrapolate(samples, 2);
    EXPECT_LE(std::abs(k.value - 3), k.error.value());
  }
}

// 1 % of noise in turn on each mesh: the bar must hold the truth, whatever the sign.
TEST(Extrapolate, TheBarHoldsTheTruthThroughNoise) {
  for (std::size_t mesh = 0; mesh < 3; ++mesh)
    for (const double noise : {-0.03, 0.03}) {
      std::vector samples{on_power_law(2.0, 2), on_power_law(1.4, 2), on_power_law(1.0, 2)};
      samples[mesh].value += noise;
      const auto k = extrapolate(samples, 2);
      EXPECT_LE(std::abs(k.value - 3), k.error.value()) << mesh << ' ' << noise;
    }
}

Sample noisy(double h, double noise) {
  return {h, on_power_law(h, 2).value, noise};
}

TEST(Extrapolate, TheBarHasRoomForTheNoiseOfTheValuesAtItsWorst) {
  const double r = 1.4 * 1.4;
  const double worst = (r * 0.01 + 0.03) / (r - 1); // the two values off in opposite directions
  EXPECT_NEAR(*extrapolate({noisy(1.4, 0.03), noisy(1.0, 0.01)}, 2).error, 1.25 * 0.2 + worst, 1e-13);
  const auto three = extrapolate({noisy(1.96, 0.1), noisy(1.4, 0.03), noisy(1.0, 0.01)}, 2);
  EXPECT_NEAR(*three.error, 0.5 * 0.2 + worst, 1e-13);
}

TEST(Extrapolate, ScatterThatTheNoiseExplainsIsNotCountedAgain) {
  const auto with_noise = [](double noise) {
    std::vector<Sample> samples;
    for (const double h : {2.0, 1.4, 1.0})
      samples.push_back(noisy(h, noise));
    samples[1].value += 0.02;
    return *extrapolate(samples, 2).error;
  };
  const double n = (1.96 + 1) / (1.96 - 1) * 0.02;
  EXPECT_NEAR(with_noise(0.02), 0.5 * (0.2 + 0.02 / 0.96) + n, 1e-12);
  EXPECT_LT(with_noise(1e-6) - with_noise(0), 1e-5); // no jump where there is next to none
}

TEST(Extrapolate, ThreeMeshesThatDoNotConvergeHaveAWideBar) {
  const auto k = extrapolate({{2.0, 5.0}, {1.4, 5.4}, {1.0, 5.1}}, 2);
  EXPECT_GE(k.error.value(), 1.25 * 0.4); // the spread of the three
}

TEST(Extrapolate, EqualValuesStayAndHaveNoError) {
  const auto k = extrapolate({{2.0, 5}, {1.4, 5}, {1.0, 5}}, 2);
  EXPECT_EQ(k.value, 5);
  EXPECT_EQ(k.error, 0);
}

TEST(Extrapolate, OneMeshOrNoOrderSaysSoByLeavingTheErrorOut) {
  EXPECT_EQ(extrapolate({{1.0, 5}}, 2), (studies::Bounded{5, std::nullopt, std::nullopt}));
  EXPECT_EQ(extrapolate({{1.0, 5}, {2.0, 6}}, std::nullopt), (studies::Bounded{5, std::nullopt, std::nullopt}));
}

TEST(Extrapolate, RefusesNothingAndTheSameMeshTwice) {
  EXPECT_THROW(extrapolate({}, 2), pfv::InputError);
  EXPECT_THROW(extrapolate({{1.0, 5}, {1.0, 5}}, 2), pfv::InputError);
}

TEST(ExtrapolateField, TreatsEveryValueAsANumber) {
  const std::vector<double> truth{1, -2, 0.5}, slope{0.1, 0.2, -0.3};
  const auto at = [&](double h) {
    std::vector<double> values(3);
    for (std::size_t i = 0; i < 3; ++i)
      values[i] = truth[i] + slope[i] * h * h;
    return values;
  };
  const std::vector mesh_sizes{1.4, 1.0};
  const std::vector fields{at(1.4), at(1.0)};
  const auto bounded = studies::extrapolate_field(mesh_sizes, fields, 2);
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_NEAR(bounded.values[i], truth[i], 1e-13);
  EXPECT_NEAR(bounded.error.value(), 1.25 * std::sqrt(0.14 / 3), 1e-13);
}

TEST(ExtrapolateField, WhatOneMeshDoesNotKnowIsUnknown) {
  const std::vector mesh_sizes{1.4, 1.0};
  const std::vector<std::vector<double>> fields{{1, std::nan("")}, {1, 2}};
  const auto bounded = studies::extrapolate_field(mesh_sizes, fields, 2);
  EXPECT_EQ(bounded.values[0], 1);
  EXPECT_TRUE(std::isnan(bounded.values[1]));
}

TEST(ExtrapolateField, RefusesListsOfDifferentPackings) {
  const std::vector mesh_sizes{1.4, 1.0};
  const std::vector<std::vector<double>> fields{{1}, {1, 2}};
  EXPECT_THROW(studies::extrapolate_field(mesh_sizes, fields, 2), pfv::InputError);
}

} // namespace
