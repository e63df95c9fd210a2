#pragma once

#include "reference/lattice_boltzmann/lattice_flow/stokes_dynamics.hpp"
#include "reference/lattice_boltzmann/wall_links.hpp"

namespace reference::lattice_boltzmann {

/// What is to be put right in one block of the lattice after each streaming step: what comes back from the faces of the
/// box, then what comes back from the spheres.
class BlockWalls {
public:
  /// A voxel of the block, its numbers counted in the box, and where it stands in the block.
  struct Place {
    std::array<int, 3> voxel;
    plb::Dot3D local;
  };

  void add_faces(const FlowQuestion& question, Block& block, const Place& place);
  void add_link(const WallLink& link, std::size_t number, Block& block, const Place& place);
  void apply() const;

  /// Calls visit(number of the link, population that went to the wall, population that came back).
  template <typename Visit>
  void visit_links(Visit visit) const {
    for (const Link& link : links_)
      visit(link.number, *link.sent, *link.returned);
  }

private:
  struct Reflection {
    double* to;
    const double* from;
    double sign;
  };
  struct Link {
    double* returned;
    const double* sent;
    const double* arrived; // in the direction sent, from behind
    const double* left;    // against it, to behind
    double weight;
    std::size_t number;
  };
  std::vector<Reflection> reflections_;
  std::vector<Link> links_;
};

} // namespace reference::lattice_boltzmann
