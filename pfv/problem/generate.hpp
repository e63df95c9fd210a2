#pragma once

#include "pfv/problem/packing.hpp"

#include <cstdint>

namespace pfv {

enum class Lattice { simple_cubic, bcc, fcc };

/// Solid fraction at which the lattice's nearest neighbours touch: pi/6, pi sqrt(3)/8, pi sqrt(2)/6.
double touching_solid_fraction(Lattice lattice);

/// cells^3 cubic cells of a lattice in a box of side `cells` times `cell_size` (m), cut by planes of symmetry: simple
/// cubic spheres sit at cell centres; bcc and fcc spheres at cell corners lie on the box faces and are cut by them.
/// Along a periodic axis those on the upper face are the images of those on the lower, so they are left out: 1, 2 and 4
/// spheres per cell where all axes are periodic. Throws InputError unless cells >= 1, cell_size > 0 and 0 <
/// solid_fraction <= touching (a relative 1e-12 above is taken as touching).
Packing lattice_packing(Lattice lattice, double solid_fraction, int cells, double cell_size = 1.0,
                        const PeriodicAxes& periodic = {});

/// Eight corner spheres tangent to three walls each and one in the middle that touches all eight, in a cube of side
/// `size` (m): r = size / (2 + 4/sqrt(3)). The first row of Table 1 of Catalano et al. 2011.
Packing nine_spheres(double size = 1.0);

/// Every coordinate moved by up to `amplitude` (m) either way, but for those that would reach a wall: what breaks the
/// ties of a lattice. The same on every machine.
Packing jittered(Packing packing, double amplitude);

struct RandomPacking {
  int spheres = 30;
  double solid_fraction = 0.5; // 0 < phi <= 0.6
  double radius_ratio = 1.0;   // largest / smallest, radii evenly spaced between them
  std::uint64_t seed = 1;
  double size = 1.0;          // m, side of the cube
  PeriodicAxes periodic = {}; // axes without walls
};

/// Spheres wholly inside a cube and nowhere overlapping, 1 % of a diameter apart where there is room. Along a periodic
/// axis their centres are in the cube, and they keep apart from one another's images (and from their own). The same
/// parameters give the same packing on every machine. Throws InputError on parameters out of range, and SolveError with
/// the fraction reached when the search jams.
Packing random_packing(const RandomPacking& parameters);

} // namespace pfv
