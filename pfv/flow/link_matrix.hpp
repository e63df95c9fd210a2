#pragma once

#include "pfv/solvers/flow_matrix.hpp"

#include <algorithm>

namespace pfv {

/// Sorts the entries of each row by column, adds up those of one column, and closes the gaps this leaves.
void sort_and_merge(FlowMatrix& matrix);

/// Where row a has its entry in column b, or -1.
int position(const FlowMatrix& matrix, int a, int b);

/// The matrix of sum_j K_ij (p_i - p_j) over the unknowns 0 ... n - 1. `visit_links(f)` calls f(a, b, K) for every
/// link; a negative a or b is a known pressure, a = b no link. Linear in the links: rows are counted, placed, filled,
/// sorted.
template <typename VisitLinks>
FlowMatrix matrix_of(int n, const VisitLinks& visit_links) {
  FlowMatrix matrix(n, n);
  int* start = matrix.outerIndexPtr();
  std::fill(start, start + n + 1, 0);
  visit_links([&](int a, int b, double) {
    if (a >= 0 && b >= 0 && a != b) {
      ++start[a];
      ++start[b];
    }
  });
  int entries = 0;
  for (int row = 0; row < n; ++row) {
    const int count = start[row] + 1;
    start[row] = entries;
    entries += count;
  }
  start[n] = entries;
  matrix.resizeNonZeros(entries);

  int* column = matrix.innerIndexPtr();
  double* value = matrix.valuePtr();
  Eigen::VectorXi next(n);
  for (int row = 0; row < n; ++row) {
    next[row] = start[row] + 1;
    column[start[row]] = row;
    value[start[row]] = 0;
  }
  visit_links([&](int a, int b, double k) {
    if (a == b)
      return;
    if (a >= 0)
      value[start[a]] += k;
    if (b >= 0)
      value[start[b]] += k;
    if (a >= 0 && b >= 0) {
      column[next[a]] = b;
      value[next[a]++] = -k;
      column[next[b]] = a;
      value[next[b]++] = -k;
    }
  });
  sort_and_merge(matrix);
  return matrix;
}

/// New values in place; whether the matrix has an entry for every link.
template <typename VisitLinks>
bool refill(FlowMatrix& matrix, const VisitLinks& visit_links) {
  double* value = matrix.valuePtr();
  std::fill(value, value + matrix.nonZeros(), 0.0);
  bool complete = true;
  visit_links([&](int a, int b, double k) {
    if (a == b)
      return;
    if (a >= 0)
      value[position(matrix, a, a)] += k;
    if (b >= 0)
      value[position(matrix, b, b)] += k;
    if (a < 0 || b < 0)
      return;
    const int ab = position(matrix, a, b), ba = position(matrix, b, a);
    complete = complete && ab >= 0 && ba >= 0;
    if (!complete)
      return;
    value[ab] -= k;
    value[ba] -= k;
  });
  return complete;
}

} // namespace pfv
