#pragma once

#include "pfv/solvers/short_rows.hpp"

#include <array>
#include <vector>

namespace pfv {

/// Where an unknown takes its pressure from: at most two unknowns of the coarser level. One that takes it from one
/// has it twice, with weights of 1 and 0 times its own; one that takes it from none has weights of zero.
struct Parents {
  std::array<int, 2> row{};
  std::array<float, 2> weight{};
};

struct Interpolation {
  std::vector<Parents> parents; // by unknown
  int coarse_rows = 0;
};

/// Conductances between pores span many decades, so that a pore's pressure is nearly that of the neighbour behind its
/// widest throat. Unknowns that follow their strongest neighbour make clusters of four or little more, around a pair
/// that is strongest to both. One of the pair is the root and keeps the pressure of the cluster; every other unknown
/// gets the pressure that balances its fluxes when each neighbour has the pressure of its own cluster (a step of
/// Jacobi, as in the Jacobi interpolation of Stueben 2001), less all but the two largest weights, which make up for the
/// rest. Unknowns without neighbours are left out: Gauss-Seidel solves them. `matrix` is SparseRows or ShortRows; the
/// inverse of its diagonal is zero where rounding has left nothing of it.
template <class Rows>
Interpolation interpolation(const Rows& matrix, const Eigen::VectorXf& inverse_diagonal);

} // namespace pfv
