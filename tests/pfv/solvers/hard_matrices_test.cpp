#include "support/solvers.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <random>

using namespace pfv;
using namespace pfv::testing;

namespace {

/// Every engine finds the pressure from A p.
void expect_found(const FlowMatrix& matrix, const Eigen::VectorXd& pressure, double tolerance = 1e-7) {
  for (const char* engine : all_engines) {
    const auto found = answer(engine, matrix, matrix * pressure);
    ASSERT_EQ(found.size(), pressure.size()) << engine;
    EXPECT_LT((found - pressure).lpNorm<Eigen::Infinity>(), tolerance * pressure.lpNorm<Eigen::Infinity>()) << engine;
  }
}

TEST(HardMatrices, NoUnknown) {
  const FlowMatrix matrix(0, 0);
  for (const char* engine : all_engines)
    EXPECT_EQ(answer(engine, matrix, Eigen::VectorXd()).size(), 0) << engine;
}

TEST(HardMatrices, OneUnknown) {
  expect_found(network_matrix({3e-15}, {}), Eigen::VectorXd::Constant(1, 7));
}

TEST(HardMatrices, NoCause) {
  const auto matrix = laplacian(400);
  for (const char* engine : all_engines)
    EXPECT_EQ(answer(engine, matrix, Eigen::VectorXd::Zero(400)), Eigen::VectorXd::Zero(400)) << engine;
}

TEST(HardMatrices, UnknownsWithoutNeighbours) {
  std::vector<double> to_known(500);
  for (std::size_t i = 0; i < to_known.size(); ++i)
    to_known[i] = std::pow(10.0, -20 + static_cast<double>(i % 7));
  expect_found(network_matrix(to_known, {}), Eigen::VectorXd::LinSpaced(500, 1, 2));
}

TEST(HardMatrices, SeparateBlocks) {
  std::vector<double> to_known(903, 0);
  std::vector<Link> links;
  for (int block = 0; block < 3; ++block) {
    const double conductance = std::pow(100.0, block);
    to_known[300 * block] = to_known[300 * block + 299] = conductance;
    for (int i = 0; i < 299; ++i)
      links.push_back({300 * block + i, 300 * block + i + 1, conductance});
  }
  for (int alone = 900; alone < 903; ++alone)
    to_known[alone] = 1;
  expect_found(network_matrix(to_known, links), Eigen::VectorXd::LinSpaced(903, 1, 2));
}

/// A box of n^3 unknowns with conductances spread evenly over some decades, held on one side.
FlowMatrix spread_box(int n, double decades) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> exponent(-decades / 2, decades / 2);
  const auto number = [n](int x, int y, int z) { return (x * n + y) * n + z; };
  std::vector<double> to_known(static_cast<std::size_t>(n * n * n), 0);
  std::vector<Link> links;
  for (int x = 0; x < n; ++x)
    for (int y = 0; y < n; ++y)
      for (int z = 0; z < n; ++z) {
        const int here = number(x, y, z);
        if (z == 0)
          to_known[here] = 1;
        if (x + 1 < n)
          links.push_back({here, number(x + 1, y, z), std::pow(10.0, exponent(random))});
        if (y + 1 < n)
          links.push_back({here, number(x, y + 1, z), std::pow(10.0, exponent(random))});
        if (z + 1 < n)
          links.push_back({here, number(x, y, z + 1), std::pow(10.0, exponent(random))});
      }
  return network_matrix(to_known, links);
}

TEST(HardMatrices, EvenBox) {
  const auto matrix = spread_box(12, 0);
  expect_found(matrix, Eigen::VectorXd::LinSpaced(matrix.rows(), 1, 2));
}

TEST(HardMatrices, TwelveDecades) {
  const auto matrix = spread_box(12, 12);
  for (const char* engine : {"cholmod", "amg", "multigrid", "auto"}) { // Gauss-Seidel would need days
    const Eigen::VectorXd right = matrix * Eigen::VectorXd::LinSpaced(matrix.rows(), 1, 2);
    const auto found = answer(engine, matrix, right);
    EXPECT_TRUE(found.allFinite()) << engine;
    EXPECT_LT((right - matrix * found).norm(), 1e-9 * right.norm()) << engine;
  }
}

TEST(HardMatrices, OneUnknownWithTenThousandNeighbours) {
  constexpr int n = 12000;
  for (const int hub : {0, n - 1}) {
    std::vector<double> to_known(n, 0);
    std::vector<Link> links;
    for (int i = 0; i < n; ++i) {
      to_known[i] = i % 100 == 0 ? 1 : 0;
      if (i != hub)
        links.push_back({hub, i, 1 + 0.1 * (i % 13)});
      if (i > 0 && i - 1 != hub && i != hub)
        links.push_back({i - 1, i, 0.5 + 0.1 * (i % 7)});
    }
    expect_found(network_matrix(to_known, links), Eigen::VectorXd::LinSpaced(n, 1, 2));
  }
}

} // namespace
