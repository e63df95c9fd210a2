#pragma once

#include "reference/stokes_fem/boundary.hpp"
#include "reference/stokes_fem/discretisation.hpp"

namespace reference::stokes_fem {

/// Numbers of the unknowns, those of a rank without gaps; a rank owns the nodes of its cells that no lower rank has.
struct Numbering {
  static constexpr int held = -1;

  std::array<std::vector<int>, 3> velocity; // by component and node, or held
  std::vector<int> pressure;                // by node
  std::vector<int> first_velocity;          // of each rank, and one past the last
  std::vector<int> first_pressure;
};

/// For a mesh whose cells have the rank that owns them as subdomain.
Numbering number_unknowns(const Discretisation& discretisation, const Boundary& boundary, int ranks);

} // namespace reference::stokes_fem
