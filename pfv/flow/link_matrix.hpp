#pragma once

#include "pfv/solvers/flow_matrix.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>
#include <vector>

namespace pfv {

/// Sorts the entries of each row by column, adds up those of one column, and closes the gaps this leaves.
void sort_and_merge(FlowMatrix& matrix);

/// Where row a has its entry in column b, or -1.
int position(const FlowMatrix& matrix, int a, int b);

/// Where the entries of a matrix are, so that new values need not be searched a place for.
struct LinkPlaces {
  std::vector<int> diagonal;               // by row
  std::vector<std::array<int, 2>> between; // of the links between two unknowns, in the order they are visited
};

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

/// Nothing when a link has no entry.
template <typename VisitLinks>
std::optional<LinkPlaces> places_of(const FlowMatrix& matrix, const VisitLinks& visit_links) {
  LinkPlaces places;
  for (int row = 0; row < matrix.rows(); ++row)
    places.diagonal.push_back(position(matrix, row, row));
  bool complete = true;
  visit_links([&](int a, int b, double) {
    if (a < 0 || b < 0 || a == b)
      return;
    const std::array place{position(matrix, a, b), position(matrix, b, a)};
    complete = complete && place[0] >= 0 && place[1] >= 0;
    places.between.push_back(place);
  });
  return complete ? std::optional(std::move(places)) : std::nullopt;
}

/// New values in place. The links are those that the places are of.
template <typename VisitLinks>
void refill(FlowMatrix& matrix, const LinkPlaces& places, const VisitLinks& visit_links) {
  double* value = matrix.valuePtr();
  std::fill(value, value + matrix.nonZeros(), 0.0);
  auto between = places.between.begin();
  visit_links([&](int a, int b, double k) {
    if (a == b)
      return;
    if (a >= 0)
      value[places.diagonal[a]] += k;
    if (b >= 0)
      value[places.diagonal[b]] += k;
    if (a < 0 || b < 0)
      return;
    value[(*between)[0]] -= k;
    value[(*between)[1]] -= k;
    ++between;
  });
}

} // namespace pfv
