#pragma once

#include "pfv/clock.hpp"
#include "pfv/pores/sites.hpp"
#include "pfv/pores/vertex.hpp"
#include "pfv/problem/packing.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace pfv {

/// The void of a packing as pores (tetrahedra of the regular triangulation; prisms and boxes at the walls) joined by
/// throats (their facets). Geometry only, in flat arrays by pore, throat or sphere; SI units. Catalano et al. 2011,
/// figure 2.
///
/// A facet and the power centres P_i, P_j of its two pores span a bipyramid, whose axis P_i P_j is normal to the facet.
/// All lengths, volumes and surfaces are signed, so that bipyramids tile the box exactly even where a centre lies on
/// the far side of its facet. Where two spheres overlap, each keeps what lies on its own side of their radical plane.
///
/// In a periodic box every pore and throat is there once; the pore ahead of a throat is then met at its centre plus a
/// shift.
struct PoreNetwork {
  Box box;
  Box walls;   // the box, without end along its periodic axes
  Sites sites; // what the vertices stand for

  struct Pores {
    std::vector<std::array<Vertex, 4>> vertices;
    std::vector<Vec3> centre;        // power centre; on the wall for a pore that touches it
    std::vector<double> volume;      // m^3, void and solid
    std::vector<double> void_volume; // m^3

    std::size_t size() const { return centre.size(); }
    bool touches(std::size_t pore, Face face) const;
  } pores;

  /// Where pores end on faces of the box: one entry for each pore and face.
  struct WallPart {
    int pore;
    Face face;
    double area; // m^2, void and solid
  };
  std::vector<WallPart> wall_parts;

  struct Throats {
    std::size_t interior = 0;              // the first ones have no wall among their vertices, all others have
    std::vector<std::array<int, 2>> pores; // i, j
    std::vector<Shift> shift;              // of j; empty unless the box is periodic
    std::vector<std::uint8_t> facet;       // of pore i: opposite that of its vertices, see PoreNetwork::corners
    std::vector<double> fluid_area;        // m^2, S_f: S less the sectors of the discs
    std::vector<double> length;            // m, l = (P_j - P_i).n
    std::vector<double> void_volume;       // m^3, Theta: of the bipyramid
    std::vector<double> wetted_surface;    // m^2, gamma: of its spheres
    std::vector<std::array<float, 3>> wetted_parts; // m^2, by vertex; a wall has its own. Single precision: shares
    std::vector<double> area;     // m^2, S: of the facet, solid included; empty unless openings were asked for
    std::vector<double> gap;      // see smallest_gap; likewise
    std::vector<double> contrast; // see pore_contrast; likewise

    std::size_t size() const { return pores.size(); }
    /// Room for what conductances are computed from, fluid_area to wetted_surface, and with openings area, gap and
    /// contrast.
    void make_room_for_shapes(bool openings);
    /// Frees that room.
    void forget_shapes();
  } throats;

  struct Spheres {
    std::vector<double> volume;                  // m^3, inside the box, as the bipyramids sum it
    std::vector<double> wetted_surface;          // m^2, inside the box, as the bipyramids sum it
    std::vector<std::array<double, 2>> of_sites; // room for these sums, in the order of sites, which is that of space
  } spheres;                                     // by number in the packing

  std::vector<int> hidden_spheres;  // without a pore of their own, so without fluid force
  std::size_t flat_pores = 0;       // whose centre, lost along their normal, is that of a neighbour
  std::size_t closed_throats = 0;   // whose facet is covered by spheres
  std::size_t inverted_throats = 0; // l < 0 beyond round-off: the topology is out of date

  PeriodicAxes periodic() const;
  /// Void volume / box volume.
  double porosity() const;
  /// The vertices of a throat in the order that turns its normal from pore i to pore j.
  std::array<Vertex, 3> corners(std::size_t throat) const {
    return facet_opposite(pores.vertices[throats.pores[throat][0]], throats.facet[throat]);
  }
  /// Centre of the pore ahead of a throat as the throat meets it (m).
  Vec3 centre_ahead(std::size_t throat) const {
    Vec3 centre = pores.centre[throats.pores[throat][1]];
    if (!throats.shift.empty())
      for (int axis = 0; axis < 3; ++axis)
        centre[axis] += throats.shift[throat][axis] * (box.upper[axis] - box.lower[axis]);
    return centre;
  }
};

/// Pores and throats of a packing. The faces across axes that are not periodic are in their exact limit as planes: a
/// pore at a wall is a prism that ends on it and a throat through it half of the throat between the packing and its
/// mirror image. Stages `cells`, `triangulate` and `geometry`. With openings, which some conductance rules read,
/// throats also have their area, gap and contrast. Throws SolveError when a pore is so flat that its centre is not
/// finite, or when the triangulation of a periodic box does not repeat.
PoreNetwork build_pore_network(const Packing& packing, const PeriodicAxes& periodic, Clock& clock,
                               bool openings = false);

/// Follows the spheres to where they are now, all else kept: stage `geometry`, nothing is allocated. As long as no
/// throat is inverted the network is that of the packing. The packing must have as many spheres as before.
void follow(PoreNetwork& network, const Packing& packing, Clock& clock);

} // namespace pfv
