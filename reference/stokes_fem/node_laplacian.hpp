#pragma once

#include "reference/stokes_fem/lanes.hpp"
#include "reference/stokes_fem/velocity_component.hpp"

namespace reference::stokes_fem {

using Velocity = std::array<Eigen::VectorXd, 3>; // free unknowns, by component

/// The Laplacians of the three components at once: one matrix over the nodes that any component is free on, in the
/// order of Cuthill and McKee 1969, and a mask that is 0 where a component is fixed, else 1.
struct NodeLaplacian {
  NodePattern pattern;
  std::vector<double> values;
  Lanes<double> mask;
  std::vector<int> node;  // of the space, by row
  std::vector<int> index; // row, by node of the space; -1 where nothing is free

  double diagonal(int row) const;
  Lanes<double> operator*(const Lanes<double>& x) const;
  Lanes<double> gather(const Velocity& velocity, const VelocityComponents& components) const;
  Velocity scatter(const Lanes<double>& lanes, const VelocityComponents& components) const;
};

NodeLaplacian node_laplacian(const SparseMatrix& lower, const VelocityComponents& components);

} // namespace reference::stokes_fem
