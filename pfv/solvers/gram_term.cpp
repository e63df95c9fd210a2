#include "pfv/solvers/gram_term.hpp"

#include <algorithm>
#include <numeric>

namespace pfv {
namespace {

GramTerm::Entries turned(const GramTerm::Entries& rows, int count) {
  GramTerm::Entries columns;
  columns.start.assign(static_cast<std::size_t>(count) + 1, 0);
  for (const auto& entry : rows.entry)
    ++columns.start[entry.index + 1];
  std::partial_sum(columns.start.begin(), columns.start.end(), columns.start.begin());
  columns.entry.resize(rows.entry.size());
  std::vector<int> next(columns.start.begin(), columns.start.end() - 1);
  for (std::size_t row = 0; row + 1 < rows.start.size(); ++row)
    for (int e = rows.start[row]; e < rows.start[row + 1]; ++e)
      columns.entry[next[rows.entry[e].index]++] = {static_cast<int>(row), rows.entry[e].value};
  return columns;
}

} // namespace

GramTerm gram_term(GramTerm::Entries by_row, int blocks) {
  GramTerm term;
  term.by_block = turned(by_row, blocks);
  term.by_row = std::move(by_row);
  return term;
}

Eigen::VectorXd diagonal(const GramTerm& term) {
  Eigen::VectorXd result(term.rows());
  for (int i = 0; i < term.rows(); ++i) {
    result[i] = 0;
    for (int e = term.by_row.start[i]; e < term.by_row.start[i + 1]; ++e)
      result[i] += term.by_row.entry[e].value.squaredNorm();
  }
  return result;
}

GramTerm coarse_term(const GramTerm& fine, const Interpolation& interpolation) {
  GramTerm::Entries by_block;
  std::vector<int> place(static_cast<std::size_t>(interpolation.coarse_rows), -1);
  for (int block = 0; block < fine.blocks(); ++block) {
    const auto first = by_block.entry.size();
    for (int e = fine.by_block.start[block]; e < fine.by_block.start[block + 1]; ++e) {
      const auto& [row, value] = fine.by_block.entry[e];
      const Parents& parents = interpolation.parents[row];
      for (int k = 0; k < 2; ++k) {
        if (parents.weight[k] == 0)
          continue;
        int& at = place[parents.row[k]];
        if (at < 0) {
          at = static_cast<int>(by_block.entry.size());
          by_block.entry.push_back({parents.row[k], Vec3::Zero()});
        }
        by_block.entry[at].value += parents.weight[k] * value;
      }
    }
    for (auto e = first; e < by_block.entry.size(); ++e)
      place[by_block.entry[e].index] = -1;
    by_block.start.push_back(static_cast<int>(by_block.entry.size()));
  }
  GramTerm coarse;
  coarse.by_row = turned(by_block, interpolation.coarse_rows);
  coarse.by_block = std::move(by_block);
  return coarse;
}

double multiply(const FlowMatrix& matrix, const GramTerm& term, const Eigen::VectorXd& x, std::vector<Vec3>& of_block,
                Eigen::VectorXd& product) {
  of_block.resize(static_cast<std::size_t>(term.blocks()));
  for (int block = 0; block < term.blocks(); ++block) {
    Vec3 sum = Vec3::Zero();
    for (int e = term.by_block.start[block]; e < term.by_block.start[block + 1]; ++e)
      sum += x[term.by_block.entry[e].index] * term.by_block.entry[e].value;
    of_block[block] = sum;
  }
  const int* start = matrix.outerIndexPtr();
  const int* column = matrix.innerIndexPtr();
  const double* value = matrix.valuePtr();
  const bool coupled = !term.empty();
  product.resize(x.size());
  double power = 0;
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    double sum = 0;
    for (int e = start[i]; e < start[i + 1]; ++e)
      sum += value[e] * x[column[e]];
    if (coupled)
      for (int e = term.by_row.start[i]; e < term.by_row.start[i + 1]; ++e)
        sum += term.by_row.entry[e].value.dot(of_block[term.by_row.entry[e].index]);
    product[i] = sum;
    power += sum * x[i];
  }
  return power;
}

} // namespace pfv
