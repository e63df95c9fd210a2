#include "reference/stokes_fem/node_laplacian.hpp"

#include <algorithm>

namespace reference::stokes_fem {

namespace {

bool is_free(const VelocityComponents& components, std::size_t node) {
  return std::ranges::any_of(components, [&](const auto& component) { return component.free_index[node] >= 0; });
}

/// Both triangles of the rows and columns of free nodes, numbered as in the space.
NodePattern free_rows(const SparseMatrix& lower, const std::vector<int>& index, std::vector<double>& values) {
  NodePattern rows;
  std::vector<int> next(index.size() + 1, 0);
  const auto for_each = [&](const auto& visit) {
    for (Eigen::Index column = 0; column < lower.outerSize(); ++column)
      for (SparseMatrix::InnerIterator it(lower, column); it; ++it) {
        const auto i = static_cast<int>(it.row()), j = static_cast<int>(column);
        if (index[static_cast<std::size_t>(i)] < 0 || index[static_cast<std::size_t>(j)] < 0)
          continue;
        visit(i, j, it.value());
        if (i != j)
          visit(j, i, it.value());
      }
  };
  for_each([&](int i, int, double) { ++next[static_cast<std::size_t>(i) + 1]; });
  for (std::size_t i = 1; i < next.size(); ++i)
    next[i] += next[i - 1];
  rows.start = next;
  rows.column.resize(static_cast<std::size_t>(rows.start.back()));
  values.resize(rows.column.size());
  for_each([&](int i, int j, double value) {
    const auto place = static_cast<std::size_t>(next[static_cast<std::size_t>(i)]++);
    rows.column[place] = j;
    values[place] = value;
  });
  return rows;
}

/// Breadth first, from the lowest node of each connected part.
void number(const NodePattern& rows, NodeLaplacian& laplacian) {
  constexpr int waiting = 0;
  for (std::size_t seed = 0; seed < laplacian.index.size(); ++seed) {
    if (laplacian.index[seed] != waiting)
      continue;
    const auto add = [&](int node) {
      laplacian.node.push_back(node);
      laplacian.index[static_cast<std::size_t>(node)] = static_cast<int>(laplacian.node.size()); // one too high
    };
    std::size_t head = laplacian.node.size();
    for (add(static_cast<int>(seed)); head < laplacian.node.size(); ++head) {
      const auto node = static_cast<std::size_t>(laplacian.node[head]);
      for (int entry = rows.start[node]; entry < rows.start[node + 1]; ++entry)
        if (const int other = rows.column[static_cast<std::size_t>(entry)];
            laplacian.index[static_cast<std::size_t>(other)] == waiting)
          add(other);
    }
  }
  for (int& row : laplacian.index)
    row = std::max(row, 0) - 1;
}

} // namespace

NodeLaplacian node_laplacian(const SparseMatrix& lower, const VelocityComponents& components) {
  NodeLaplacian laplacian;
  laplacian.index.assign(static_cast<std::size_t>(lower.rows()), -1);
  for (std::size_t node = 0; node < laplacian.index.size(); ++node)
    if (is_free(components, node))
      laplacian.index[node] = 0;
  std::vector<double> values;
  const NodePattern rows = free_rows(lower, laplacian.index, values);
  number(rows, laplacian);

  NodePattern& pattern = laplacian.pattern;
  pattern.column.reserve(rows.column.size());
  laplacian.values.reserve(values.size());
  std::vector<std::pair<int, double>> row;
  for (const int node : laplacian.node) {
    row.clear();
    for (int entry = rows.start[static_cast<std::size_t>(node)]; entry < rows.start[static_cast<std::size_t>(node) + 1];
         ++entry)
      row.emplace_back(laplacian.index[static_cast<std::size_t>(rows.column[static_cast<std::size_t>(entry)])],
                       values[static_cast<std::size_t>(entry)]);
    std::ranges::sort(row);
    for (const auto& [column, value] : row) {
      pattern.column.push_back(column);
      laplacian.values.push_back(value);
    }
    pattern.start.push_back(static_cast<int>(pattern.column.size()));
  }
  laplacian.mask = Lanes<double>::Zero(4, pattern.rows());
  for (std::size_t c = 0; c < 3; ++c)
    for (int i = 0; i < pattern.rows(); ++i)
      if (components[c].free_index[static_cast<std::size_t>(laplacian.node[static_cast<std::size_t>(i)])] >= 0)
        laplacian.mask(static_cast<Eigen::Index>(c), i) = 1;
  return laplacian;
}

double NodeLaplacian::diagonal(int row) const {
  const auto begin = pattern.column.begin() + pattern.start[static_cast<std::size_t>(row)];
  const auto end = pattern.column.begin() + pattern.start[static_cast<std::size_t>(row) + 1];
  return values[static_cast<std::size_t>(std::lower_bound(begin, end, row) - pattern.column.begin())];
}

Lanes<double> NodeLaplacian::operator*(const Lanes<double>& x) const {
  Lanes<double> product(4, pattern.rows());
  for (int row = 0; row < pattern.rows(); ++row) {
    Eigen::Array4d sum = Eigen::Array4d::Zero();
    for (auto entry = static_cast<std::size_t>(pattern.start[static_cast<std::size_t>(row)]);
         entry < static_cast<std::size_t>(pattern.start[static_cast<std::size_t>(row) + 1]); ++entry)
      sum += values[entry] * x.col(pattern.column[entry]);
    product.col(row) = sum * mask.col(row);
  }
  return product;
}

Lanes<double> NodeLaplacian::gather(const Velocity& velocity, const VelocityComponents& components) const {
  Lanes<double> lanes = Lanes<double>::Zero(4, pattern.rows());
  for (std::size_t c = 0; c < 3; ++c)
    for (int row = 0; row < pattern.rows(); ++row)
      if (const int free = components[c].free_index[static_cast<std::size_t>(node[static_cast<std::size_t>(row)])];
          free >= 0)
        lanes(static_cast<Eigen::Index>(c), row) = velocity[c][free];
  return lanes;
}

Velocity NodeLaplacian::scatter(const Lanes<double>& lanes, const VelocityComponents& components) const {
  Velocity velocity;
  for (std::size_t c = 0; c < 3; ++c) {
    velocity[c].resize(components[c].size);
    for (int row = 0; row < pattern.rows(); ++row)
      if (const int free = components[c].free_index[static_cast<std::size_t>(node[static_cast<std::size_t>(row)])];
          free >= 0)
        velocity[c][free] = lanes(static_cast<Eigen::Index>(c), row);
  }
  return velocity;
}

} // namespace reference::stokes_fem
