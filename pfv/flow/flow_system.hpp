#pragma once

#include "pfv/flow/conductance.hpp"
#include "pfv/flow/flow_matrix.hpp"
#include "pfv/pores/pore_network.hpp"
#include "pfv/problem/face.hpp"

#include <cstddef>
#include <vector>

namespace pfv {

/// Continuity in every pore, sum_j K_ij (p_i - p_j) = 0 (Catalano et al. 2011, eq. (10)), as a symmetric positive
/// definite system over the pores whose pressure is not known.
///
/// Pores joined by a throat whose conductance exceeds `contraction` times the median are one unknown: their centres
/// (nearly) coincide, as in the cospherical cells of a lattice, and so do their pressures. A pore that touches a
/// Pressure face has its centre on it and so its pressure, and all it is contracted with.
struct FlowSystem {
  static constexpr double contraction = 1e6;
  static constexpr int known = -1;    // unknown_of_pore: the pressure is that of a face
  static constexpr int isolated = -2; // unknown_of_pore: no way to a known pressure

  std::vector<double> conductance; // m^3/(Pa s) by throat; 0 within an unknown
  std::vector<int> unknown_of_pore;
  std::vector<double> known_pressure; // Pa by pore; the mean of the faces for isolated pores
  std::vector<int> face_of_pore;      // index(Face) of the face that gives the pressure, or -1
  FlowMatrix matrix;                  // m^3/(Pa s)
  Eigen::VectorXd right_side;         // m^3/s

  std::size_t contracted_throats = 0;
  std::size_t raised_throats = 0;
  std::size_t isolated_pores = 0;

  std::size_t unknowns() const { return static_cast<std::size_t>(right_side.size()); }
};

/// Throws SolveError when faces of different pressure meet in one pore.
FlowSystem assemble(const PoreNetwork& network, const Conductances& conductances, const FaceConditions& faces);

/// Pressure of every pore (Pa) from the solution of the system.
std::vector<double> pore_pressures(const FlowSystem& system, const Eigen::VectorXd& solution);

/// Flux through each Pressure face (m^3/s), positive out of the box; zero on walls.
std::array<double, 6> face_fluxes(const PoreNetwork& network, const FlowSystem& system,
                                  const std::vector<double>& pressure);

} // namespace pfv
