#include "reference/stokes_fem/edge_ends.hpp"

namespace reference::stokes_fem {

namespace {

/// Of the ten nodes of a quadratic tetrahedron, as local numbers.
std::array<std::array<unsigned, 2>, 10> local_ends(const dealii::FiniteElement<3>& quadratic) {
  const auto& points = quadratic.get_unit_support_points();
  std::array<std::array<unsigned, 2>, 10> ends{};
  for (unsigned node = 0; node < 10; ++node)
    for (unsigned a = 0; a < 4; ++a)
      for (unsigned b = 0; b <= a; ++b)
        if (points[node].distance(points[a] + 0.5 * (points[b] - points[a])) < 1e-12)
          ends[node] = {a, b};
  return ends;
}

} // namespace

std::vector<std::array<int, 2>> edge_ends(const Discretisation& space) {
  const auto local = local_ends(space.quadratic);
  std::vector<std::array<int, 2>> ends(space.velocity_nodes);
  Dofs nodes(10);
  for (const auto& cell : space.mesh.active_cell_iterators()) {
    velocity_nodes(space, cell, nodes);
    for (unsigned node = 0; node < 10; ++node)
      ends[nodes[node]] = {static_cast<int>(nodes[local[node][0]]), static_cast<int>(nodes[local[node][1]])};
  }
  return ends;
}

} // namespace reference::stokes_fem
