#include "pfv/solvers/coarse_matrix.hpp"

#include "pfv/solvers/row_order.hpp"

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
    order.follow(coarse);
  }
  order.finish(coarse, interpolation);
  return coarse;
}

template SparseRows coarse_matrix(const MatrixView<double>&, Interpolation&, double, const GramTerm&);
template SparseRows coarse_matrix(const MatrixView<float>&, Interpolation&, double, const GramTerm&);

} // namespace pfv
