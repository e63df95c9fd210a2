#pragma once

#include "pfv/flow/conductance.hpp"
#include "pfv/flow/link_matrix.hpp"
#include "pfv/pores/pore_network.hpp"
#include "pfv/problem/case.hpp"
#include "pfv/solvers/flow_matrix.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace pfv {

/// Continuity in every pore, sum_j K_ij (p_i - p_j) = 0 (Catalano et al. 2011, eq. (10)), as a symmetric positive
/// definite system over the pores whose pressure is not known.
///
/// Pores joined by a throat whose conductance exceeds `contraction` times the median are one unknown: their centres
/// (nearly) coincide, as in the cospherical cells of a lattice, and so do their pressures. Where the pressure is known:
/// known_pressures. Where the box is periodic the pressure rises by `rise` from one box to the next, so that a throat
/// whose pore ahead is met s boxes away carries K (p_i - p_j - rise.s). When nothing but that rise drives the flow, one
/// pore of every connected part is held at zero.
struct FlowSystem {
  static constexpr double contraction = 1e6;
  static constexpr double wide_open = 1e3; // medians: what `refresh` asks of a contracted throat

  /// A pore that is no unknown: its pressure is imposed, or it is held at zero, or isolated, without a way to a known
  /// pressure, and then at the mean of the imposed ones.
  struct KnownPore {
    int source;      // index(Face) or 6 + number of the pressure point that gives the pressure, or -1
    double pressure; // Pa, as at the first pore of its group
  };

  std::vector<double> conductance;  // m^3/(Pa s) by throat; 0 where contracted
  std::vector<bool> contracted;     // by throat
  std::vector<int> unknown_of_pore; // negative for a known pore
  std::vector<KnownPore> known_pores;
  std::vector<Shift> offset; // boxes from a pore to the first of its group; empty unless the box is periodic
  FaceConditions faces;
  std::size_t points = 0;           // with a pressure
  double level = 0;                 // Pa, the mean of the imposed pressures: the unknowns are pressures above it
  Vec3 rise = Vec3::Zero();         // Pa, from one box to the next
  FlowMatrix matrix;                // m^3/(Pa s)
  std::optional<LinkPlaces> places; // once the matrix has been refreshed
  Eigen::VectorXd right_side;       // m^3/s

  std::size_t contracted_throats = 0;
  std::size_t rounded_throats = 0;
  std::size_t isolated_pores = 0;
  std::size_t held_pores = 0; // at zero, because nothing else sets the level of their pressure

  /// Nothing when the pressure of the pore is an unknown.
  const KnownPore* known(std::size_t pore) const {
    const int unknown = unknown_of_pore[pore];
    return unknown < 0 ? &known_pores[~unknown] : nullptr;
  }
  std::size_t unknowns() const { return static_cast<std::size_t>(right_side.size()); }
};

/// What the pressure is of pores without a way to a known one: the mean of the imposed ones; or, where they hold fluid,
/// one more unknown, for a fluid whose storage on the diagonal sets its level. Without storage the matrix is then
/// singular.
enum class Isolated { at_mean, unknown };

/// Linear in time, the matrix built in place. Throws SolveError when different pressures meet in one pore.
FlowSystem assemble(const PoreNetwork& network, Conductances conductances, const FaceConditions& faces,
                    std::span<const PressurePoint> points = {}, Isolated isolated = Isolated::at_mean);

/// New conductances, and profiles where pores are now, into the same pattern, without allocation but for the first
/// time; the pressure of Flux faces is zero again. A throat that turns around, as where four spheres change partners,
/// conducts without bound for a moment; here it gets `wide_open` medians, along which no pressure drops either, so that
/// the pattern can stay. Returns false, and leaves the system to be assembled anew, when a contracted throat is no
/// longer wide open or throats open or close.
bool refresh(FlowSystem& system, const PoreNetwork& network, const Conductances& conductances);

/// Imposes another pressure (Pa) on all pores that have theirs from this face. The right side is left as it is.
void impose(FlowSystem& system, Face face, double pressure);

/// Whether a path of throats joins pores whose imposed pressures differ, or boxes a rise. Where none does, what flows
/// is round-off.
bool has_way(const FlowSystem& system, const PoreNetwork& network);

/// The right side of the pressures that are imposed now.
void renew_right_side(FlowSystem& system, const PoreNetwork& network);

/// Pressure of every pore (Pa) from the solution of the system.
void set_pore_pressures(const FlowSystem& system, const Eigen::VectorXd& solution, std::vector<double>& pressure);
std::vector<double> pore_pressures(const FlowSystem& system, const Eigen::VectorXd& solution);

/// By how many boxes the group of the pore ahead is met away from that of the pore behind.
inline Shift crossing(const FlowSystem& system, const PoreNetwork& network, std::size_t throat) {
  if (system.offset.empty())
    return {};
  const auto [i, j] = network.throats.pores[throat];
  return network.throats.shift[throat] + system.offset[i] - system.offset[j];
}

} // namespace pfv
