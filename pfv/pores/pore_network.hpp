#pragma once

#include "pfv/clock.hpp"
#include "pfv/pores/vertex.hpp"
#include "pfv/problem/packing.hpp"

#include <array>
#include <cstddef>
#include <vector>

namespace pfv {

/// The void of a packing as pores (tetrahedra of the regular triangulation; prisms and boxes at the walls) joined by
/// throats (their facets). Geometry only, in flat arrays by pore, throat or sphere; SI units. Catalano et al. 2011,
/// figure 2.
///
/// A facet and the power centres P_i, P_j of its two pores span a bipyramid, whose axis P_i P_j is normal to the facet.
/// All lengths, volumes and surfaces are signed, so that bipyramids tile the box exactly even where a centre lies on
/// the far side of its facet.
struct PoreNetwork {
  Box box;

  struct Pores {
    std::vector<std::array<Vertex, 4>> vertices;
    std::vector<Vec3> centre;                     // power centre; on the wall for a pore that touches it
    std::vector<double> volume;                   // m^3, void and solid
    std::vector<double> void_volume;              // m^3
    std::vector<std::array<double, 6>> wall_area; // m^2 of each face of the box, void and solid

    std::size_t size() const { return centre.size(); }
    bool touches(std::size_t pore, Face face) const;
  } pores;

  struct Throats {
    std::vector<std::array<int, 2>> pores; // i, j
    std::vector<std::array<Vertex, 3>> vertices;
    std::vector<Vec3> normal;                          // unit, from i to j
    std::vector<double> area;                          // m^2, S
    std::vector<double> fluid_area;                    // m^2, S_f: S less the sectors of the discs
    std::vector<double> length;                        // m, l = (P_j - P_i).n
    std::vector<double> void_volume;                   // m^3, Theta: of the bipyramid
    std::vector<std::array<double, 3>> wetted_surface; // m^2, gamma by vertex; none on walls
    std::vector<std::array<double, 3>> sector_area;    // m^2, A_k by vertex

    std::size_t size() const { return pores.size(); }
    double total_wetted_surface(std::size_t throat) const {
      const auto& surface = wetted_surface[throat];
      return surface[0] + surface[1] + surface[2];
    }
  } throats;

  struct Spheres {
    std::vector<double> volume;         // m^3, inside the box, as the bipyramids sum it
    std::vector<double> wetted_surface; // m^2, inside the box, as the bipyramids sum it
  } spheres;

  std::vector<int> hidden_spheres; // without a pore of their own, so without fluid force

  /// Void volume / box volume.
  double porosity() const;
};

/// Pores and throats of a packing, the six faces of the box in their exact limit as planes: a pore at a wall is a prism
/// that ends on it and a throat through it half of the throat between the packing and its mirror image.
/// Stages `triangulate` and `geometry`. Throws SolveError when a pore is so flat that its centre is not finite.
PoreNetwork build_pore_network(const Packing& packing, Clock& clock);

} // namespace pfv
