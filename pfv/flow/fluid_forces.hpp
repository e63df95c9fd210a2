#pragma once

#include "pfv/flow/flow_system.hpp"
#include "pfv/flow/wall_rules.hpp"
#include "pfv/pores/pore_network.hpp"
#include "pfv/problem/case.hpp"

#include <array>
#include <optional>
#include <vector>

namespace pfv {

/// Force of the fluid on every sphere, by origin (N). Catalano et al. 2011, eq. (9); Chareyre et al. 2012.
struct FluidForces {
  std::vector<Vec3> pressure;                // of the piezometric pressure on the sphere's surface
  std::vector<Vec3> viscous;                 // of the shear stress
  std::optional<std::vector<Vec3>> buoyancy; // - rho_f g V; when the case names it
  std::array<Vec3, 6> on_face{};             // on the faces of the box, by index(Face); no buoyancy

  struct OfSite {
    Vec3 pressure = Vec3::Zero(), viscous = Vec3::Zero();
  };
  std::vector<OfSite> of_sites; // room for the sums, in the order of sites, which is that of space

  /// Pressure and viscous force on one sphere: what the flow does.
  Vec3 of_flow(std::size_t sphere) const { return pressure[sphere] + viscous[sphere]; }
};

/// Each throat carries (p_i - p_j) n S: the sphere k takes its sector of the facet, A_k, as pressure force and its
/// share gamma_k / gamma of the fluid area S_f as viscous force. A no-slip wall takes its share of S_f, any other none.
/// The sum over spheres and faces is zero to round-off, because the facets of a pore close; in a periodic box it is the
/// mean gradient times the volume.
FluidForces fluid_forces(const PoreNetwork& network, const FlowSystem& system, const std::vector<double>& pressure,
                         const WallRule& walls, const std::optional<Buoyancy>& buoyancy);

/// The same in place: nothing is allocated when there are as many spheres as before.
void update(FluidForces& forces, const PoreNetwork& network, const FlowSystem& system,
            const std::vector<double>& pressure, const WallRule& walls, const std::optional<Buoyancy>& buoyancy);

} // namespace pfv
