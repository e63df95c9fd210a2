#pragma once

#include "reference/openfoam/case_files.hpp"
#include "reference/openfoam/cell_search.hpp"
#include "reference/openfoam/flow_fields.hpp"

namespace reference::openfoam {

/// Velocity linear in each cell: its value at its centre and the gradient that fits those of its neighbours best (least
/// squares weighted by distance^-2), with zero velocity on solid and no velocity across slip walls. Pressures of
/// tetrahedra scatter from cell to cell: the one at a point is that of the linear function that fits the neighbours,
/// their neighbours and the pressures of open faces best. In the units of the fields.
class LinearFlow {
public:
  LinearFlow(const FoamMesh& mesh, const CellSearch& search, const FlowFields& fields, const pfv::Case& problem);

  double pressure(std::size_t cell, const pfv::Vec3& point) const;
  pfv::Vec3 velocity(std::size_t cell, const pfv::Vec3& point) const;

private:
  std::vector<std::size_t> neighbours(std::size_t cell) const;
  double reach_of(std::size_t cell) const; // squared distance of the farthest neighbour

  const FoamMesh& mesh_;
  const CellSearch& search_;
  const FlowFields& fields_;
  std::vector<std::optional<double>> known_; // pressure by boundary face
  std::vector<Eigen::Matrix3d> slopes_;      // of the velocity by cell, rows: components
};

} // namespace reference::openfoam
