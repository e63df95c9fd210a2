#pragma once

#include "pfv/flow/wall_rules.hpp"
#include "pfv/pores/pore_network.hpp"

#include <array>
#include <span>
#include <vector>

namespace pfv {

// Bodies are the spheres by number in the packing, then the six walls by index(Face).

/// How the motion of grains and walls changes the volume of pores, and, adjoint to it, how the pressures of pores push
/// grains and walls.
///
/// The solid moves through a facet of area S at sum_k w_k v_k.n, where w_k is what the force on sphere k has of it: its
/// sector A_k and its share of the fluid area by wetted surface, together S. Summed over the facets of pore i that is
/// sum_c g_ic.v_c over its four vertices; the force on body k is sum g_ic p_i over the pores it is a vertex of. One
/// matrix B does both, so the fluid can only take energy: v.F = - p.A p. In Catalano et al. 2011, eq. (4), dV_i/dt
/// follows from the vertices alone; with the forces of eq. (9) that is not adjoint. No rule's shear_spread acts here.
struct SolidFlux {
  std::vector<std::array<Vec3, 4>> weight; // m^2, g by pore and vertex, out of the pore
  std::vector<std::array<int, 4>> body;    // by pore and vertex
  std::size_t bodies = 0;

  std::size_t pores() const { return body.size(); }
};

/// Images of a sphere are that sphere.
SolidFlux solid_flux(const PoreNetwork& network, const WallRule& walls);

/// m^3/s by pore: what the solid carries out of it when the bodies move at these velocities (m/s).
void volume_rates(const SolidFlux& flux, std::span<const Vec3> velocity, std::vector<double>& rate);

/// N by body: what pressures by pore (Pa) do. All of them sum to zero.
void pressure_forces(const SolidFlux& flux, std::span<const double> pressure, std::vector<Vec3>& force);

} // namespace pfv
