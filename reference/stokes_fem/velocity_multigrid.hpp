#pragma once

#include "reference/stokes_fem/node_laplacian.hpp"

namespace reference::stokes_fem {

/// Approximate inverse of the three velocity Laplacians, symmetric and of single precision: a sweep of Gauss-Seidel
/// over the nodes of the quadratic elements in ascending order, a correction of the linear elements by one symmetric
/// sweep over theirs (Galerkin matrix), a sweep in descending order. Between dense spheres most corners of elements
/// lie on spheres, so that the linear level is some tenth of the quadratic one and a sweep nearly solves it.
class VelocityMultigrid {
public:
  /// `ends` as in StokesSystem. Keeps a reference to the Laplacian.
  VelocityMultigrid(const NodeLaplacian& laplacian, const std::vector<std::array<int, 2>>& ends);

  Lanes<double> operator()(const Lanes<double>& residual) const;

private:
  struct Level {
    const NodePattern& pattern;
    std::vector<float> values;
    Lanes<float> weight; // mask over diagonal

    void sweep_up_from_zero(const Lanes<float>& right_side, Lanes<float>& x) const;
    void sweep_down(const Lanes<float>& right_side, Lanes<float>& x) const;
  };

  Lanes<float> restricted_residual(const Lanes<float>& right_side, const Lanes<float>& x) const;
  void add_correction(const Lanes<float>& coarse, Lanes<float>& x) const;

  std::vector<std::array<int, 2>> parents_; // corners at the ends of a middle's edge, a corner's own number twice
  NodePattern coarse_pattern_;
  Level fine_;
  Level coarse_;
  Lanes<float> fine_mask_;
};

} // namespace reference::stokes_fem
