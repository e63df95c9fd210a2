#include "pfv/solvers/coarse_matrix.hpp"

#include <cstddef>
#include <numeric>

namespace pfv {
namespace {

/// The unknowns of which a coarse row is a parent: P'.
SparseRows children(const Interpolation& interpolation) {
  SparseRows result;
  result.start.assign(static_cast<std::size_t>(interpolation.coarse_rows) + 1, 0);
  for (const Parents& parents : interpolation.parents)
    for (int k = 0; k < 2; ++k)
      if (parents.weight[k] != 0)
        ++result.start[parents.row[k] + 1];
  std::partial_sum(result.start.begin(), result.start.end(), result.start.begin());
  result.column.resize(static_cast<std::size_t>(result.start.back()));
  result.value.resize(static_cast<std::size_t>(result.start.back()));
  std::vector<int> next(result.start.begin(), result.start.end() - 1);
  for (std::size_t i = 0; i < interpolation.parents.size(); ++i)
    for (int k = 0; k < 2; ++k)
      if (const float weight = interpolation.parents[i].weight[k]; weight != 0) {
        const int place = next[interpolation.parents[i].row[k]]++;
        result.column[place] = static_cast<int>(i);
        result.value[place] = weight;
      }
  return result;
}

/// One row while it is summed.
class RowSum {
public:
  explicit RowSum(int columns) : place_(static_cast<std::size_t>(columns), -1) {}

  void add(int column, double value) {
    int& place = place_[column];
    if (place < 0) {
      place = static_cast<int>(columns_.size());
      columns_.push_back(column);
      values_.push_back(value);
    } else
      values_[place] += value;
  }

  /// In the order of a MatrixView: left of the diagonal, diagonal, right of it.
  void move_to(SparseRows& matrix) {
    const int row = matrix.rows();
    const auto append_if = [&](auto&& wanted) {
      for (std::size_t k = 0; k < columns_.size(); ++k)
        if (wanted(columns_[k])) {
          matrix.column.push_back(columns_[k]);
          matrix.value.push_back(static_cast<float>(values_[k]));
        }
    };
    append_if([row](int column) { return column < row; });
    append_if([row](int column) { return column == row; });
    append_if([row](int column) { return column > row; });
    matrix.start.push_back(static_cast<int>(matrix.column.size()));
    for (const int column : columns_)
      place_[column] = -1;
    columns_.clear();
    values_.clear();
  }

private:
  std::vector<int> place_; // by column
  std::vector<int> columns_;
  std::vector<double> values_;
};

} // namespace

template <class Value>
SparseRows coarse_matrix(const MatrixView<Value>& fine, const Interpolation& interpolation, double scale,
                         const GramTerm& term) {
  const SparseRows restriction = children(interpolation);
  SparseRows coarse;
  coarse.start.reserve(static_cast<std::size_t>(interpolation.coarse_rows) + 1);
  coarse.column.reserve(fine.column.size()); // what stays unused is never touched, so takes no memory
  coarse.value.reserve(fine.column.size());
  RowSum sum(interpolation.coarse_rows);
  for (int row = 0; row < interpolation.coarse_rows; ++row) {
    for (int r = restriction.start[row]; r < restriction.start[row + 1]; ++r) {
      const int i = restriction.column[r];
      for (int e = fine.start[i]; e < fine.start[i + 1]; ++e) {
        const Parents& parents = interpolation.parents[fine.column[e]];
        const double value = scale * restriction.value[r] * fine.value[e];
        for (int k = 0; k < 2; ++k)
          if (parents.weight[k] != 0)
            sum.add(parents.row[k], value * parents.weight[k]);
      }
    }
    if (!term.empty())
      for (int r = term.by_row.start[row]; r < term.by_row.start[row + 1]; ++r) {
        const auto& [block, value] = term.by_row.entry[r];
        for (int e = term.by_block.start[block]; e < term.by_block.start[block + 1]; ++e)
          sum.add(term.by_block.entry[e].index, scale * value.dot(term.by_block.entry[e].value));
      }
    sum.move_to(coarse);
  }
  return coarse;
}

template SparseRows coarse_matrix(const MatrixView<double>&, const Interpolation&, double, const GramTerm&);
template SparseRows coarse_matrix(const MatrixView<float>&, const Interpolation&, double, const GramTerm&);

} // namespace pfv
