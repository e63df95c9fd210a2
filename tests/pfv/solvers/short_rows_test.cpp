#include "pfv/solvers/short_rows.hpp"

#include "support/solvers.hpp"

#include <gtest/gtest.h>
#include <vector>

using namespace pfv;
using namespace pfv::testing;

namespace {

/// A ring of 40, of which unknowns 7 and 39 are linked to nine others as well and the first to a known pressure.
FlowMatrix ring_with_hubs() {
  std::vector<double> to_known(40, 0);
  to_known[0] = 1e-9; // next to nothing beside the links
  std::vector<Link> links;
  for (int i = 0; i < 40; ++i)
    links.push_back({i, (i + 1) % 40, 1.0 + i});
  for (int k = 0; k < 9; ++k) {
    links.push_back({7, 10 + k, 0.5});
    links.push_back({39, 20 + k, 0.25});
  }
  return network_matrix(to_known, links);
}

TEST(ShortRows, HoldEveryEntryBesideTheDiagonalInBothDirections) {
  const FlowMatrix matrix = ring_with_hubs();
  ShortRows rows;
  Eigen::VectorXf diagonal, sum;
  rows.take(view(matrix), 2, diagonal, sum);
  ASSERT_EQ(rows.rows(), matrix.rows());

  Eigen::MatrixXd rest = 2 * Eigen::MatrixXd(matrix);
  std::vector<int> up, down;
  rows.ascending([&](int row, auto columns, auto values) {
    up.push_back(row);
    rest(row, row) -= diagonal[row];
    for (std::size_t k = 0; k < columns.size(); ++k)
      rest(row, columns[k]) -= values[k];
  });
  rows.descending([&](int row, auto, auto) { down.push_back(row); });
  EXPECT_LT(rest.cwiseAbs().maxCoeff(), 1e-5);
  for (int i = 0; i < rows.rows(); ++i) {
    EXPECT_EQ(up[i], i);
    EXPECT_EQ(down[i], rows.rows() - 1 - i);
  }
}

TEST(ShortRows, KeepWhatIsLeftOfARow) {
  const FlowMatrix matrix = ring_with_hubs();
  ShortRows rows;
  Eigen::VectorXf diagonal, sum;
  rows.take(view(matrix), 1, diagonal, sum);
  EXPECT_NEAR(sum[0], 1e-9, 1e-14); // though its diagonal is 41
  EXPECT_LT(sum.tail(39).cwiseAbs().maxCoeff(), 1e-13F);
}

} // namespace
