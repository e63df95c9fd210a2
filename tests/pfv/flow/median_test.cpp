#include "pfv/flow/median.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <random>

using pfv::positive_median;

namespace {

TEST(PositiveMedian, IsTheMiddleOfWhatIsPositiveAndFinite) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  EXPECT_EQ(positive_median({}), 0);
  EXPECT_EQ(positive_median({0, -1, infinite}), 0);
  EXPECT_EQ(positive_median({infinite, 3, 0, 1, -5, 2, infinite}), 2);
  EXPECT_EQ(positive_median({1, 2, 3, 4}), 3);
}

TEST(PositiveMedian, IsThatOfAllInOrder) {
  std::mt19937 random(1);
  for (const double decades : {1e-12, 1e-3, 1.0, 300.0})
    for (const std::size_t count : {1, 2, 1000, 1001}) {
      std::vector<double> values(count);
      for (double& value : values)
        value = std::pow(10, decades * (static_cast<double>(random()) / 0x1p32 - 0.5));
      const double median = positive_median(values);
      std::ranges::sort(values);
      EXPECT_EQ(median, values[count / 2]);
    }
}

} // namespace
