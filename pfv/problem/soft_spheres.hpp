#pragma once

#include "pfv/problem/face.hpp"
#include "pfv/problem/vec3.hpp"

#include <vector>

namespace pfv {

/// Spheres in the unit cube that push one another and the walls apart where they overlap, with the energy
/// sum (overlap^2) / 2. Along a periodic axis there are no walls, but images.
struct SoftSpheres {
  std::vector<Vec3> centres;
  std::vector<double> radii;
  PeriodicAxes periodic = {};
};

/// Centres, in the cube also along periodic axes, and the deepest overlap, relative to the sum of the two radii or to
/// the radius at a wall.
struct Relaxed {
  std::vector<Vec3> centres;
  double worst_overlap;
};

/// Moves the spheres down the energy until no relative overlap exceeds `tolerance`, or the pushes balance (the spheres
/// are jammed), or `most_steps` are taken. FIRE: Bitzek et al., Phys. Rev. Lett. 97 (2006) 170201.
Relaxed relax(const SoftSpheres& spheres, double tolerance, int most_steps);

} // namespace pfv
