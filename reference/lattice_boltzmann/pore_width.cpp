#include "reference/lattice_boltzmann/pore_width.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace reference::lattice_boltzmann {

namespace {

double part_inside(const pfv::Sphere& sphere, const pfv::Box& box, const pfv::PeriodicAxes& periodic) {
  double part = 1;
  for (int a = 0; a < 3; ++a)
    if (!periodic[static_cast<std::size_t>(a)])
      part *= (std::min(box.upper[a], sphere.centre[a] + sphere.radius) -
               std::max(box.lower[a], sphere.centre[a] - sphere.radius)) /
              (2 * sphere.radius);
  return part;
}

} // namespace

double VoidMeasures::quickest_viscosity() const {
  return std::clamp(width * width / length, 0.03, 2.0);
}

// Fitted to lattices of 1 to 4 spheres, nine spheres and 200 random ones, 200 to 1300 steps: within a factor 2. The
// second term is for pores so wide that the quickest viscosity is not taken.
double VoidMeasures::steps_to_rest() const {
  return 100 + 12 * length + 1.3 * width * width / quickest_viscosity();
}

VoidMeasures void_measures(const pfv::Case& problem, const VoxelGrid& grid) {
  const auto periodic = pfv::periodic_axes(problem.faces);
  double solid = 0;
  double surface = 0;
  for (const pfv::Sphere& sphere : problem.packing.spheres) {
    const double radius = sphere.radius / grid.size;
    const double area = 4 * std::numbers::pi * radius * radius * part_inside(sphere, problem.packing.box, periodic);
    surface += area;
    solid += area * radius / 3;
  }
  const double pores = std::max(grid.count() - solid, 0.1 * grid.count()); // overlaps are counted twice
  return {surface, pores / surface, static_cast<double>(std::ranges::max(grid.voxels))};
}

} // namespace reference::lattice_boltzmann
