#include "pfv/solvers/coarse_matrix.hpp"

#include <algorithm>
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

/// One row while it is summed. Which columns come again nobody can guess, so nothing branches on it.
class RowSum {
public:
  explicit RowSum(int columns) : sums_(static_cast<std::size_t>(columns)) {}

  /// Makes room for so many calls of `add`.
  void expect(int entries) {
    if (count_ + static_cast<std::size_t>(entries) > columns_.size())
      columns_.resize(2 * (count_ + static_cast<std::size_t>(entries)));
  }

  void add(int column, double value) {
    Sum& sum = sums_[column];
    const bool is_new = sum.row != row_;
    columns_[count_] = column;
    count_ += is_new ? 1 : 0;
    sum.value += value;
    sum.row = row_;
  }

  void move_to(SparseRows& matrix) {
    const std::size_t first = matrix.column.size();
    matrix.column.resize(first + count_);
    matrix.value.resize(first + count_);
    for (std::size_t k = 0; k < count_; ++k) {
      Sum& sum = sums_[columns_[k]];
      matrix.column[first + k] = columns_[k];
      matrix.value[first + k] = static_cast<float>(sum.value);
      sum.value = 0;
    }
    matrix.start.push_back(static_cast<int>(first + count_));
    ++row_;
    count_ = 0;
  }

private:
  struct Sum {
    double value = 0;
    int row = -1; // of which it is
  };

  int row_ = 0;
  std::size_t count_ = 0;
  std::vector<int> columns_; // the first `count_`, each once
  std::vector<Sum> sums_;    // by column; zero but for this row
};

/// Puts rows of one length next to each other, 64 at a time: they stay near in memory, and where a row ends is no
/// surprise to loops over them.
class RowOrder {
public:
  explicit RowOrder(int rows) : place_(static_cast<std::size_t>(rows)) {}

  /// The rows of the matrix from the last call on.
  void arrange_new_rows(SparseRows& matrix) {
    const int rows = matrix.rows(), first = matrix.start[done_];
    column_.assign(matrix.column.begin() + first, matrix.column.end());
    value_.assign(matrix.value.begin() + first, matrix.value.end());
    start_.assign(matrix.start.begin() + done_, matrix.start.end());
    const auto length = [this](int row) { return start_[row + 1] - start_[row]; };
    row_.resize(static_cast<std::size_t>(rows - done_));
    next_.clear(); // by length
    for (int row = 0; row < rows - done_; ++row) {
      next_.resize(std::max(next_.size(), static_cast<std::size_t>(length(row)) + 2));
      ++next_[length(row) + 1];
    }
    std::partial_sum(next_.begin(), next_.end(), next_.begin());
    for (int row = 0; row < rows - done_; ++row) {
      const int place = next_[length(row)]++;
      place_[done_ + row] = done_ + place;
      row_[place] = row;
    }
    int end = first;
    for (const int row : row_) {
      std::copy_n(column_.begin() + (start_[row] - first), length(row), matrix.column.begin() + end);
      std::copy_n(value_.begin() + (start_[row] - first), length(row), matrix.value.begin() + end);
      end += length(row);
      matrix.start[++done_] = end;
    }
  }

  void renumber(SparseRows& matrix, Interpolation& interpolation) const {
    for (int& column : matrix.column)
      column = place_[column];
    for (Parents& parents : interpolation.parents)
      for (int& row : parents.row)
        row = place_[row];
  }

private:
  int done_ = 0;
  std::vector<int> place_; // by row as it came
  std::vector<int> row_, next_, start_, column_;
  std::vector<float> value_;
};

/// Asks for what the children after a place will read, which nobody else can guess. Inline, as a function that does
/// nothing else counts as one without effect.
template <class Value>
[[gnu::always_inline]] inline void prefetch(const MatrixView<Value>& fine, const Interpolation& interpolation,
                                            std::span<const int> children, std::size_t place) {
  constexpr std::size_t row_ahead = 16, parents_ahead = 5;
  if (place + row_ahead >= children.size())
    return;
  const int first = fine.start[children[place + row_ahead]];
  __builtin_prefetch(&fine.column[first]);
  __builtin_prefetch(&fine.value[first]);
  const int row = children[place + parents_ahead];
  for (int e = fine.start[row]; e < fine.start[row + 1]; ++e)
    __builtin_prefetch(&interpolation.parents[fine.column[e]]);
}

} // namespace

template <class Value>
SparseRows coarse_matrix(const MatrixView<Value>& fine, Interpolation& interpolation, double scale,
                         const GramTerm& term) {
  constexpr int rows_together = 64;
  const SparseRows restriction = children(interpolation);
  SparseRows coarse;
  coarse.start.reserve(static_cast<std::size_t>(interpolation.coarse_rows) + 1);
  coarse.column.reserve(fine.column.size()); // what stays unused is never touched, so takes no memory
  coarse.value.reserve(fine.column.size());
  RowSum sum(interpolation.coarse_rows);
  RowOrder order(interpolation.coarse_rows);
  for (int row = 0; row < interpolation.coarse_rows; ++row) {
    for (int r = restriction.start[row]; r < restriction.start[row + 1]; ++r) {
      const int i = restriction.column[r];
      prefetch(fine, interpolation, restriction.column, static_cast<std::size_t>(r));
      sum.expect(2 * (fine.start[i + 1] - fine.start[i]));
      for (int e = fine.start[i]; e < fine.start[i + 1]; ++e) {
        const Parents& parents = interpolation.parents[fine.column[e]];
        const double value = scale * restriction.value[r] * fine.value[e];
        if (parents.weight[0] != 0)
          for (int k = 0; k < 2; ++k)
            sum.add(parents.row[k], value * parents.weight[k]);
      }
    }
    if (!term.empty())
      for (int r = term.by_row.start[row]; r < term.by_row.start[row + 1]; ++r) {
        const auto& [block, value] = term.by_row.entry[r];
        sum.expect(term.by_block.start[block + 1] - term.by_block.start[block]);
        for (int e = term.by_block.start[block]; e < term.by_block.start[block + 1]; ++e)
          sum.add(term.by_block.entry[e].index, scale * value.dot(term.by_block.entry[e].value));
      }
    sum.move_to(coarse);
    if (coarse.rows() % rows_together == 0)
      order.arrange_new_rows(coarse);
  }
  order.arrange_new_rows(coarse);
  order.renumber(coarse, interpolation);
  return coarse;
}

template SparseRows coarse_matrix(const MatrixView<double>&, Interpolation&, double, const GramTerm&);
template SparseRows coarse_matrix(const MatrixView<float>&, Interpolation&, double, const GramTerm&);

} // namespace pfv
