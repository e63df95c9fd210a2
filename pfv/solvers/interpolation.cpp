#include "pfv/solvers/interpolation.hpp"

#include <cstddef>

namespace pfv {
namespace {

constexpr int none = -1;

struct Clusters {
  std::vector<int> of_row; // none for a row without neighbours
  std::vector<int> root;   // row by cluster
};

/// The column of the most negative entry of every row, or none.
template <class Value>
std::vector<int> strongest_neighbours(const MatrixView<Value>& matrix) {
  std::vector<int> strongest(static_cast<std::size_t>(matrix.rows()), none);
  for (int i = 0; i < matrix.rows(); ++i) {
    Value largest = 0;
    for (int e = matrix.start[i]; e < matrix.start[i + 1]; ++e)
      if (matrix.value[e] < largest) {
        largest = matrix.value[e];
        strongest[i] = matrix.column[e];
      }
  }
  return strongest;
}

/// Walks from every row along strongest neighbours until the walk meets itself or a cluster. From its end, the rows of
/// the walk join that cluster while it has room, then found the next; a last one does not stay alone.
Clusters follow_strongest(const std::vector<int>& strongest) {
  constexpr int walking = -2, largest_cluster = 4;
  Clusters clusters{std::vector<int>(strongest.size(), none), {}};
  std::vector<int> size, walk;
  for (std::size_t i = 0; i < strongest.size(); ++i) {
    if (strongest[i] == none)
      continue;
    walk.clear();
    int row = static_cast<int>(i);
    for (; row != none && clusters.of_row[row] == none; row = strongest[row]) {
      clusters.of_row[row] = walking;
      walk.push_back(row);
    }
    int cluster = row == none ? none : clusters.of_row[row];
    for (std::size_t k = walk.size(); k-- > 0;) {
      const bool full = cluster >= 0 && size[cluster] >= largest_cluster;
      if (cluster < 0 || (full && k > 0)) {
        cluster = static_cast<int>(size.size());
        clusters.root.push_back(walk[k]);
        size.push_back(0);
      }
      clusters.of_row[walk[k]] = cluster;
      ++size[cluster];
    }
  }
  return clusters;
}

/// The two largest of the weights given to `add`, scaled to the sum of all.
class TwoLargest {
public:
  explicit TwoLargest(std::size_t clusters) : weight_(clusters, 0) {}

  void add(int cluster, float weight) {
    if (weight_[cluster] == 0)
      touched_.push_back(cluster);
    weight_[cluster] += weight;
  }

  Parents take() {
    constexpr float negligible = 0.2F;
    Parents parents;
    float first = 0, second = 0, sum = 0;
    for (const int cluster : touched_) {
      const float weight = weight_[cluster];
      sum += weight;
      if (weight > first) {
        second = first;
        first = weight;
        parents.row = {cluster, parents.row[0]};
      } else if (weight > second) {
        second = weight;
        parents.row[1] = cluster;
      }
      weight_[cluster] = 0;
    }
    touched_.clear();
    if (second <= negligible * first) {
      second = 0;
      parents.row[1] = parents.row[0];
    }
    if (first > 0)
      parents.weight = {sum * first / (first + second), sum * second / (first + second)};
    return parents;
  }

private:
  std::vector<float> weight_; // by cluster
  std::vector<int> touched_;
};

} // namespace

template <class Value>
Interpolation interpolation(const MatrixView<Value>& matrix) {
  const Clusters clusters = follow_strongest(strongest_neighbours(matrix));
  Interpolation result{std::vector<Parents>(static_cast<std::size_t>(matrix.rows())),
                       static_cast<int>(clusters.root.size())};
  TwoLargest two_largest(clusters.root.size());
  for (int i = 0; i < matrix.rows(); ++i) {
    const int cluster = clusters.of_row[i];
    if (cluster == none)
      continue;
    if (clusters.root[cluster] == i) {
      result.parents[i] = {{cluster, cluster}, {1, 0}};
      continue;
    }
    Value diagonal = 0;
    for (int e = matrix.start[i]; e < matrix.start[i + 1]; ++e)
      if (matrix.column[e] == i)
        diagonal = matrix.value[e];
    if (!(diagonal > 0))
      continue; // rounding has left nothing of it
    for (int e = matrix.start[i]; e < matrix.start[i + 1]; ++e)
      if (const int of_neighbour = clusters.of_row[matrix.column[e]]; matrix.column[e] != i && of_neighbour != none)
        two_largest.add(of_neighbour, static_cast<float>(-matrix.value[e] / diagonal));
    result.parents[i] = two_largest.take();
  }
  return result;
}

template Interpolation interpolation(const MatrixView<double>&);
template Interpolation interpolation(const MatrixView<float>&);

} // namespace pfv
