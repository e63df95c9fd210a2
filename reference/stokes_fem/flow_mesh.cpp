#include "reference/stokes_fem/flow_mesh.hpp"

#include "reference/stokes_fem/discretisation.hpp"

namespace reference::stokes_fem {

using pfv::Vec3;

QuadraticCell FlowMesh::cell(std::size_t index) const {
  QuadraticCell made;
  for (std::size_t i = 0; i < 10; ++i)
    made.points[i] = position[cells[index][i]];
  return made;
}

Vec3 FlowMesh::velocity_at(std::size_t cell, const Weights& weights) const {
  const auto values = QuadraticCell::shape(weights);
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = 0; i < 10; ++i)
    sum += values[static_cast<int>(i)] * velocity[cells[cell][i]];
  return sum;
}

double FlowMesh::pressure_at(std::size_t cell, const Weights& weights) const {
  double sum = 0;
  for (std::size_t i = 0; i < 4; ++i)
    sum += weights[static_cast<int>(i)] * pressure[cells[cell][i]];
  return sum;
}

FlowMesh flow_mesh(const Discretisation& space, const FlowField& flow) {
  FlowMesh made;
  const std::size_t count = space.velocity.n_dofs();
  made.position.resize(count);
  made.velocity.resize(count);
  made.pressure.assign(count, 0);
  Dofs nodes(10);
  Dofs pressures(4);
  for (const auto& cell : space.mesh.active_cell_iterators()) {
    cell_of(space.velocity, cell)->get_dof_indices(nodes);
    cell_of(space.pressure, cell)->get_dof_indices(pressures);
    const auto points = space.mapping->points(cell);
    auto& own = made.cells.emplace_back();
    made.is_curved.push_back(space.mapping->is_curved(cell));
    for (std::size_t i = 0; i < 10; ++i) {
      const auto node = nodes[i];
      own[i] = static_cast<unsigned>(node);
      made.position[node] = {points[i][0], points[i][1], points[i][2]};
      for (std::size_t c = 0; c < 3; ++c)
        made.velocity[node][static_cast<int>(c)] = flow.velocity[c][space.velocity_node[node]];
      if (i < 4)
        made.pressure[node] = flow.pressure[space.pressure_node[pressures[i]]];
    }
  }
  return made;
}

} // namespace reference::stokes_fem
