#include "reference/stokes_fem/stokes_ranks/numbering.hpp"

#include <algorithm>

namespace reference::stokes_fem {

namespace {

template <class NodesOf>
std::vector<unsigned> owners(const Discretisation& space, std::size_t count, Dofs nodes, const NodesOf& nodes_of) {
  std::vector<unsigned> owner(count, dealii::numbers::invalid_subdomain_id);
  for (const auto& cell : space.mesh.active_cell_iterators()) {
    nodes_of(space, cell, nodes);
    for (const auto node : nodes)
      owner[node] = std::min<unsigned>(owner[node], cell->subdomain_id());
  }
  return owner;
}

// Nodes of each rank in their order; a rank's nodes are about as near to each other as the mesh file has them.
std::vector<std::vector<std::size_t>> by_rank(const std::vector<unsigned>& owner, int ranks) {
  std::vector<std::vector<std::size_t>> nodes(static_cast<std::size_t>(ranks));
  for (std::size_t node = 0; node < owner.size(); ++node)
    nodes[owner[node]].push_back(node);
  return nodes;
}

} // namespace

Numbering number_unknowns(const Discretisation& space, const Boundary& boundary, int ranks) {
  Numbering numbering;
  for (auto& component : numbering.velocity)
    component.assign(space.velocity_nodes, Numbering::held);
  int count = 0;
  for (const auto& nodes : by_rank(owners(space, space.velocity_nodes, Dofs(10), velocity_nodes), ranks)) {
    numbering.first_velocity.push_back(count);
    for (const std::size_t node : nodes)
      for (std::size_t c = 0; c < 3; ++c)
        if (boundary.holder[c][node] == Boundary::free)
          numbering.velocity[c][node] = count++;
  }
  numbering.first_velocity.push_back(count);
  numbering.pressure.resize(space.pressure_nodes);
  count = 0;
  for (const auto& nodes : by_rank(owners(space, space.pressure_nodes, Dofs(4), pressure_nodes), ranks)) {
    numbering.first_pressure.push_back(count);
    for (const std::size_t node : nodes)
      numbering.pressure[node] = count++;
  }
  numbering.first_pressure.push_back(count);
  return numbering;
}

} // namespace reference::stokes_fem
