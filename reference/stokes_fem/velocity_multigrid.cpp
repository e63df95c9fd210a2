#include "reference/stokes_fem/velocity_multigrid.hpp"

#include <algorithm>

namespace reference::stokes_fem {

namespace {

/// Free corners numbered in the order of the rows they are: -1 for middles of edges.
std::vector<int> corner_numbers(const NodeLaplacian& laplacian, const std::vector<std::array<int, 2>>& ends) {
  std::vector<int> number;
  int corners = 0;
  for (const int node : laplacian.node)
    number.push_back(ends[static_cast<std::size_t>(node)][0] == node ? corners++ : -1);
  return number;
}

std::vector<std::array<int, 2>> parents_of(const NodeLaplacian& laplacian,
                                           const std::vector<std::array<int, 2>>& ends) {
  const std::vector<int> number = corner_numbers(laplacian, ends);
  std::vector<std::array<int, 2>> parents;
  for (const int node : laplacian.node) {
    std::array<int, 2>& of_node = parents.emplace_back();
    for (std::size_t end = 0; end < 2; ++end) {
      const int row = laplacian.index[static_cast<std::size_t>(ends[static_cast<std::size_t>(node)][end])];
      of_node[end] = row >= 0 ? number[static_cast<std::size_t>(row)] : -1;
    }
  }
  return parents;
}

SparseRows interpolation(const std::vector<std::array<int, 2>>& parents) {
  int corners = 0;
  std::vector<Eigen::Triplet<double>> halves;
  for (std::size_t row = 0; row < parents.size(); ++row)
    for (const int parent : parents[row])
      if (parent >= 0) {
        halves.emplace_back(static_cast<int>(row), parent, 0.5);
        corners = std::max(corners, parent + 1);
      }
  SparseRows matrix(static_cast<Eigen::Index>(parents.size()), corners);
  matrix.setFromTriplets(halves.begin(), halves.end());
  return matrix;
}

// Where a component is fixed at a corner it is so at the middles of all edges of that boundary, so that one Galerkin
// matrix and a mask serve all components.
SparseRows galerkin(const NodeLaplacian& laplacian, const std::vector<std::array<int, 2>>& parents) {
  const NodePattern& pattern = laplacian.pattern;
  const Eigen::Map<const SparseRows> fine(pattern.rows(), pattern.rows(),
                                          static_cast<Eigen::Index>(pattern.column.size()), pattern.start.data(),
                                          pattern.column.data(), laplacian.values.data());
  const SparseRows up = interpolation(parents);
  const SparseRows half = fine * up;
  const SparseRows product = SparseRows(up.transpose()) * half;
  return SparseRows(SparseMatrix(product)); // sorts each row
}

Lanes<float> weights(const Lanes<double>& mask, const auto& diagonal) {
  Lanes<float> weight(4, mask.cols());
  for (Eigen::Index row = 0; row < mask.cols(); ++row)
    weight.col(row) = (mask.col(row) / diagonal(row)).template cast<float>();
  return weight;
}

} // namespace

VelocityMultigrid::VelocityMultigrid(const NodeLaplacian& laplacian, const std::vector<std::array<int, 2>>& ends)
    : parents_(parents_of(laplacian, ends)), fine_{laplacian.pattern, {}, {}}, coarse_{coarse_pattern_, {}, {}},
      fine_mask_(laplacian.mask.cast<float>()) {
  fine_.values.assign(laplacian.values.begin(), laplacian.values.end());
  fine_.weight = weights(laplacian.mask, [&](auto row) { return laplacian.diagonal(static_cast<int>(row)); });

  const SparseRows coarse = galerkin(laplacian, parents_);
  coarse_pattern_.start.assign(coarse.outerIndexPtr(), coarse.outerIndexPtr() + coarse.rows() + 1);
  coarse_pattern_.column.assign(coarse.innerIndexPtr(), coarse.innerIndexPtr() + coarse.nonZeros());
  coarse_.values.assign(coarse.valuePtr(), coarse.valuePtr() + coarse.nonZeros());
  Lanes<double> coarse_mask(4, coarse.rows());
  for (std::size_t row = 0; row < parents_.size(); ++row)
    if (const auto [first, second] = parents_[row]; first >= 0 && first == second)
      coarse_mask.col(first) = laplacian.mask.col(static_cast<Eigen::Index>(row));
  coarse_.weight = weights(coarse_mask, [&](auto row) { return coarse.coeff(row, row); });
}

void VelocityMultigrid::Level::sweep_up_from_zero(const Lanes<float>& right_side, Lanes<float>& x) const {
  for (int row = 0; row < pattern.rows(); ++row) {
    Eigen::Array4f sum = right_side.col(row);
    for (auto entry = static_cast<std::size_t>(pattern.start[static_cast<std::size_t>(row)]);
         pattern.column[entry] < row; ++entry)
      sum -= values[entry] * x.col(pattern.column[entry]);
    x.col(row) = sum * weight.col(row);
  }
}

void VelocityMultigrid::Level::sweep_down(const Lanes<float>& right_side, Lanes<float>& x) const {
  for (int row = pattern.rows() - 1; row >= 0; --row)
    x.col(row) += row_residual(pattern, values, right_side, x, row) * weight.col(row);
}

Lanes<float> VelocityMultigrid::restricted_residual(const Lanes<float>& right_side, const Lanes<float>& x) const {
  Lanes<float> coarse = Lanes<float>::Zero(4, coarse_pattern_.rows());
  for (int row = 0; row < fine_.pattern.rows(); ++row) {
    const auto& parents = parents_[static_cast<std::size_t>(row)];
    if (std::ranges::max(parents) < 0)
      continue;
    const Eigen::Array4f half =
        0.5F * fine_mask_.col(row) * row_residual(fine_.pattern, fine_.values, right_side, x, row);
    for (const int parent : parents)
      if (parent >= 0)
        coarse.col(parent) += half;
  }
  return coarse;
}

void VelocityMultigrid::add_correction(const Lanes<float>& coarse, Lanes<float>& x) const {
  for (int row = 0; row < fine_.pattern.rows(); ++row)
    for (const int parent : parents_[static_cast<std::size_t>(row)])
      if (parent >= 0)
        x.col(row) += 0.5F * fine_mask_.col(row) * coarse.col(parent);
}

Lanes<double> VelocityMultigrid::operator()(const Lanes<double>& residual) const {
  const double scale = residual.abs().maxCoeff(); // single precision has not the range of what converges to zero
  if (!(scale > 0))
    return Lanes<double>::Zero(4, residual.cols());
  const Lanes<float> right_side = (residual / scale).cast<float>();
  Lanes<float> x(4, residual.cols());
  fine_.sweep_up_from_zero(right_side, x);
  const Lanes<float> coarse_right_side = restricted_residual(right_side, x);
  Lanes<float> coarse(4, coarse_right_side.cols());
  coarse_.sweep_up_from_zero(coarse_right_side, coarse);
  coarse_.sweep_down(coarse_right_side, coarse);
  add_correction(coarse, x);
  fine_.sweep_down(right_side, x);
  return scale * x.cast<double>();
}

} // namespace reference::stokes_fem
