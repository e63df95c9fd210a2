#include "pfv/solvers/gram_term.hpp"

#include <gtest/gtest.h>

using namespace pfv;

namespace {

/// Rows that share blocks with the next few.
GramTerm chain(int rows, int blocks) {
  GramTerm::Entries by_row;
  for (int i = 0; i < rows; ++i) {
    for (int k = 0; k < 3; ++k)
      by_row.entry.push_back({(i / 2 + k) % blocks, Vec3(std::sin(i + k), std::cos(3.0 * i), i - 2.0 * k)});
    by_row.start.push_back(static_cast<int>(by_row.entry.size()));
  }
  return gram_term(std::move(by_row), blocks);
}

Eigen::MatrixXd dense(const GramTerm& term) {
  Eigen::MatrixXd c = Eigen::MatrixXd::Zero(term.rows(), 3 * term.blocks());
  for (int i = 0; i < term.rows(); ++i)
    for (int e = term.by_row.start[i]; e < term.by_row.start[i + 1]; ++e)
      c.row(i).segment<3>(3 * term.by_row.entry[e].index) += term.by_row.entry[e].value;
  return c * c.transpose();
}

TEST(GramTerm, DiagonalIsThatOfTheProduct) {
  const GramTerm term = chain(12, 7);
  EXPECT_LT((diagonal(term) - dense(term).diagonal()).norm(), 1e-12);
}

TEST(GramTerm, CoarseTermIsGalerkins) {
  const GramTerm fine = chain(12, 7);
  Interpolation interpolation{std::vector<Parents>(12), 4};
  for (int i = 0; i < 12; ++i)
    interpolation.parents[i] = {{i / 3, (i + 1) / 3 % 4}, {0.75F, i % 2 == 0 ? 0.25F : 0.0F}};
  Eigen::MatrixXd p = Eigen::MatrixXd::Zero(12, 4);
  for (int i = 0; i < 12; ++i)
    for (int k = 0; k < 2; ++k)
      p(i, interpolation.parents[i].row[k]) += interpolation.parents[i].weight[k];
  const Eigen::MatrixXd expected = p.transpose() * dense(fine) * p;
  EXPECT_LT((dense(coarse_term(fine, interpolation)) - expected).norm(), 1e-12 * expected.norm());
}

} // namespace
