#include "pfv/solvers/interpolation.hpp"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>

namespace pfv {
namespace {

constexpr int none = -1;

struct Clusters {
  std::vector<int> of_row; // none for a row without neighbours
  std::vector<int> root;   // row by cluster
};

/// The column of the most negative entry of every row, or none. Compares bits, as a select by them is no branch, which
/// nobody could guess: as unsigned numbers, those of negative values come after all others, the largest last.
template <class Rows>
std::vector<int> strongest_neighbours(const Rows& matrix) {
  std::vector<int> strongest(static_cast<std::size_t>(matrix.rows()), none);
  matrix.ascending([&](int i, auto columns, auto values) {
    auto most = std::bit_cast<std::uint32_t>(-0.0F);
    int neighbour = none;
    for (std::size_t k = 0; k < columns.size(); ++k) {
      const auto strength = std::bit_cast<std::uint32_t>(values[k]);
      neighbour = strength > most ? columns[k] : neighbour;
      most = std::max(most, strength);
    }
    strongest[i] = neighbour;
  });
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

/// The two largest of the weights given to `add`, scaled to the sum of all. By selects, as nobody can guess which
/// clusters come again and which is the largest.
class TwoLargest {
public:
  explicit TwoLargest(std::size_t clusters) : weight_(clusters, 0) {}

  /// Makes room for so many calls of `add`.
  void expect(std::size_t weights) {
    if (touched_.size() < weights)
      touched_.resize(weights);
  }

  void add(int cluster, float weight) {
    touched_[count_++] = cluster;
    weight_[cluster] += weight;
  }

  Parents take() {
    constexpr float negligible = 0.2F;
    Candidate first = 0, second = 0;
    float sum = 0;
    for (std::size_t k = 0; k < count_; ++k) {
      const int cluster = touched_[k];
      const float weight = weight_[cluster]; // zero when the cluster comes again
      weight_[cluster] = 0;
      sum += weight;
      const Candidate candidate = candidate_of(cluster, weight);
      second = std::max(second, std::min(first, candidate));
      first = std::max(first, candidate);
    }
    count_ = 0;
    const float most = weight_of(first), more = weight_of(second);
    const bool alone = more <= negligible * most;
    const float scale = most > 0 ? sum / (most + (alone ? 0 : more)) : 0;
    return {{cluster_of(first), cluster_of(alone ? first : second)}, {scale * most, alone ? 0 : scale * more}};
  }

private:
  /// A weight and its cluster. Its order is that of the weights, where they are positive, and others come before.
  using Candidate = std::int64_t;

  static Candidate candidate_of(int cluster, float weight) {
    return Candidate{std::bit_cast<std::int32_t>(weight)} << 32 | Candidate{cluster};
  }
  static float weight_of(Candidate candidate) {
    return std::bit_cast<float>(static_cast<std::int32_t>(candidate >> 32));
  }
  static int cluster_of(Candidate candidate) { return static_cast<int>(candidate); }

  std::vector<float> weight_; // by cluster
  std::vector<int> touched_;  // the first `count_`
  std::size_t count_ = 0;
};

} // namespace

template <class Rows>
Interpolation interpolation(const Rows& matrix, const Eigen::VectorXf& inverse_diagonal) {
  const Clusters clusters = follow_strongest(strongest_neighbours(matrix));
  Interpolation result{std::vector<Parents>(static_cast<std::size_t>(matrix.rows())),
                       static_cast<int>(clusters.root.size())};
  TwoLargest two_largest(clusters.root.size());
  matrix.ascending([&](int i, auto columns, auto values) {
    const int cluster = clusters.of_row[i];
    if (cluster == none)
      return;
    if (clusters.root[cluster] == i) {
      result.parents[i] = {{cluster, cluster}, {1, 0}};
      return;
    }
    two_largest.expect(columns.size());
    for (std::size_t k = 0; k < columns.size(); ++k)
      if (const int of_neighbour = clusters.of_row[columns[k]]; of_neighbour != none)
        two_largest.add(of_neighbour, columns[k] != i ? -inverse_diagonal[i] * values[k] : 0);
    result.parents[i] = two_largest.take();
  });
  return result;
}

template Interpolation interpolation(const SparseRows&, const Eigen::VectorXf&);
template Interpolation interpolation(const ShortRows&, const Eigen::VectorXf&);

} // namespace pfv
