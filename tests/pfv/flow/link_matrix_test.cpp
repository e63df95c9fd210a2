#include "pfv/flow/link_matrix.hpp"

#include <gtest/gtest.h>
#include <random>
#include <vector>

using namespace pfv;

namespace {

struct Link {
  int a, b;
  double k;
};

auto visitor(const std::vector<Link>& links) {
  return [&](const auto& visit) {
    for (const auto& [a, b, k] : links)
      visit(a, b, k);
  };
}

Eigen::MatrixXd dense(int n, const std::vector<Link>& links) {
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(n, n);
  for (const auto& [a, b, k] : links) {
    if (a == b)
      continue;
    if (a >= 0)
      matrix(a, a) += k;
    if (b >= 0)
      matrix(b, b) += k;
    if (a >= 0 && b >= 0) {
      matrix(a, b) -= k;
      matrix(b, a) -= k;
    }
  }
  return matrix;
}

/// Few unknowns and many links, so that most links are double and rows short and long.
std::vector<Link> random_links(int n, int count, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::vector<Link> links;
  for (int l = 0; l < count; ++l)
    links.push_back({static_cast<int>(random() % (n + 1)) - 1, static_cast<int>(random() % (n + 1)) - 1,
                     1 + static_cast<double>(random() % 100)});
  return links;
}

TEST(LinkMatrix, IsTheSumOfItsLinks) {
  for (const auto& [n, count] : {std::pair{1, 3}, {5, 40}, {20, 2000}, {300, 900}}) {
    const auto links = random_links(n, count, 7);
    const FlowMatrix matrix = matrix_of(n, visitor(links));
    EXPECT_TRUE(matrix.isCompressed());
    EXPECT_EQ((Eigen::MatrixXd(matrix) - dense(n, links)).norm(), 0) << n;
    for (int row = 0; row < n; ++row)
      for (int e = matrix.outerIndexPtr()[row] + 1; e < matrix.outerIndexPtr()[row + 1]; ++e)
        EXPECT_LT(matrix.innerIndexPtr()[e - 1], matrix.innerIndexPtr()[e]);
  }
}

TEST(LinkMatrix, MayBeEmpty) {
  const FlowMatrix matrix = matrix_of(0, visitor({{-1, -1, 3}}));
  EXPECT_EQ(matrix.rows(), 0);
  EXPECT_EQ(matrix.nonZeros(), 0);
}

TEST(LinkMatrix, TakesNewValuesInPlace) {
  auto links = random_links(30, 200, 1);
  FlowMatrix matrix = matrix_of(30, visitor(links));
  for (auto& link : links)
    link.k = 2 * link.k + 1;
  const auto places = places_of(matrix, visitor(links));
  ASSERT_TRUE(places);
  refill(matrix, *places, visitor(links));
  EXPECT_EQ((Eigen::MatrixXd(matrix) - dense(30, links)).norm(), 0);
}

TEST(LinkMatrix, SaysWhenALinkHasNoEntry) {
  const FlowMatrix matrix = matrix_of(3, visitor({{0, 1, 1.0}}));
  EXPECT_FALSE(places_of(matrix, visitor({{0, 2, 1.0}})));
}

} // namespace
