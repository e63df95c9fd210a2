#include "pfv/flow/link_matrix.hpp"

#include <tuple>
#include <utility>
#include <vector>

namespace pfv {
namespace {

constexpr int short_row = 32;

void sort_short(int* column, double* value, int count) {
  for (int i = 1; i < count; ++i) {
    const int c = column[i];
    const double v = value[i];
    int j = i;
    for (; j > 0 && column[j - 1] > c; --j) {
      column[j] = column[j - 1];
      value[j] = value[j - 1];
    }
    column[j] = c;
    value[j] = v;
  }
}

/// Of a group of many contracted pores.
void sort_long(int* column, double* value, int count) {
  std::vector<std::pair<int, double>> entries(count);
  for (int i = 0; i < count; ++i)
    entries[i] = {column[i], value[i]};
  std::ranges::stable_sort(entries, {}, &std::pair<int, double>::first);
  for (int i = 0; i < count; ++i)
    std::tie(column[i], value[i]) = entries[i];
}

} // namespace

void sort_and_merge(FlowMatrix& matrix) {
  int* start = matrix.outerIndexPtr();
  int* column = matrix.innerIndexPtr();
  double* value = matrix.valuePtr();
  int kept = 0;
  for (int row = 0; row < matrix.rows(); ++row) {
    const int first = start[row], count = start[row + 1] - first;
    (count <= short_row ? sort_short : sort_long)(column + first, value + first, count);
    start[row] = kept;
    for (int e = first; e < first + count; ++e) {
      if (kept > start[row] && column[kept - 1] == column[e]) {
        value[kept - 1] += value[e];
      } else {
        column[kept] = column[e];
        value[kept++] = value[e];
      }
    }
  }
  start[matrix.rows()] = kept;
  matrix.resizeNonZeros(kept);
}

int position(const FlowMatrix& matrix, int a, int b) {
  const int* column = matrix.innerIndexPtr();
  const int *first = column + matrix.outerIndexPtr()[a], *last = column + matrix.outerIndexPtr()[a + 1];
  const int* found = last - first <= short_row ? std::find_if(first, last, [b](int c) { return c >= b; })
                                               : std::lower_bound(first, last, b);
  return found != last && *found == b ? static_cast<int>(found - column) : -1;
}

} // namespace pfv
