#pragma once

#include "reference/openfoam/case_files.hpp"
#include "reference/openfoam/cell_search.hpp"
#include "reference/openfoam/flow_fields.hpp"

namespace reference::openfoam {

/// Pressure and velocity linear in each cell: its value at its centre and the gradient that fits those of its
/// neighbours best (least squares weighted by distance^-2), with zero velocity on solid, no velocity across slip walls
/// and the pressures of the open faces. In the units of the fields.
class LinearFlow {
public:
  LinearFlow(const FoamMesh& mesh, const CellSearch& search, const FlowFields& fields, const pfv::Case& problem);

  double pressure(std::size_t cell, const pfv::Vec3& point) const;
  pfv::Vec3 velocity(std::size_t cell, const pfv::Vec3& point) const;

private:
  struct Slope {
    pfv::Vec3 pressure;
    Eigen::Matrix3d velocity; // rows: components
  };

  const FoamMesh& mesh_;
  const FlowFields& fields_;
  std::vector<Slope> slopes_; // by cell
};

} // namespace reference::openfoam
