#pragma once

#include "reference/stokes_fem/quadratic_cell.hpp"
#include "reference/stokes_fem/tractions.hpp"

#include <vector>

namespace reference::stokes_fem {

/// A flow and the curved cells it is known in, as plain arrays by node; nodes that are one in a periodic box are there
/// more than once.
struct FlowMesh {
  std::vector<pfv::Vec3> position;
  std::vector<pfv::Vec3> velocity;
  std::vector<double> pressure; // at corners only, zero on the middles of edges
  std::vector<std::array<unsigned, 10>> cells;
  std::vector<bool> is_curved; // by cell

  QuadraticCell cell(std::size_t index) const;
  pfv::Vec3 velocity_at(std::size_t cell, const Weights& weights) const;
  double pressure_at(std::size_t cell, const Weights& weights) const;
};

FlowMesh flow_mesh(const Discretisation& discretisation, const FlowField& flow);

} // namespace reference::stokes_fem
