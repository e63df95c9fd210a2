#include "reference/stokes_fem/estimate_cost.hpp"

#include "meshing/element_size.hpp"
#include "meshing/periodic_images.hpp"
#include "meshing/void_mesh.hpp"

#include <algorithm>
#include <cmath>

namespace reference::stokes_fem {

namespace {

using pfv::Vec3;

bool in_void(const pfv::Packing& packing, const Vec3& point) {
  return std::ranges::none_of(packing.spheres, [&](const pfv::Sphere& sphere) {
    return (point - sphere.centre).squaredNorm() < sphere.radius * sphere.radius;
  });
}

// Mean over the points of the three-dimensional Kronecker sequence of the plastic number, which fill a box evenly.
double volume_in_elements(const pfv::Packing& packing, const meshing::ElementSize& element_size) {
  constexpr double plastic = 1.22074408460575947536;
  const Vec3 step(1 / plastic, 1 / (plastic * plastic), 1 / (plastic * plastic * plastic));
  const double spheres = static_cast<double>(packing.spheres.size());
  const int points = static_cast<int>(std::clamp(2e7 / spheres, 2e3, 4e4));
  double sum = 0;
  for (int n = 1; n <= points; ++n) {
    const Vec3 whole = n * step;
    const Vec3 fraction = whole - Vec3(whole.array().floor());
    const Vec3 point = packing.box.lower + fraction.cwiseProduct(packing.box.size());
    if (in_void(packing, point))
      sum += std::pow(element_size(point), -3);
  }
  return packing.box.volume() * sum / points;
}

// All constants are fits to runs on one core at mesher sizes 0.85, 1.19 and 1.7. Unknowns: 30, 200 and 2000 random
// spheres, nine touching ones, loose lattices, 4e3 to 2e7, within 20 %; a box with a single touching sphere, where the
// bridges count, has 1.3 to 1.9 times as many. Meshing: 200 and 2000 random spheres. Assembling, solving and memory (a
// tenth is added to that): nine touching, 30 and 200 random spheres, 3e5 to 2e6 unknowns.

double unknowns_of(double elements, double mesh_size) {
  // The second term: close to surfaces meshes are never as coarse as asked for.
  return (22 + 11 * mesh_size) * elements;
}

double seconds_of(double unknowns, double mesh_size, double spheres) {
  const double meshing = 0.15 * spheres + 1.2e-5 * unknowns;
  const double assembling = 7e-6 * unknowns;
  // Finer meshes take more iterations, larger packings hardly any.
  const double solving = unknowns * (6e-6 + 1.55e-5 / mesh_size);
  return meshing + assembling + solving;
}

double bytes_of(double unknowns, double mesh_size) {
  return 4e7 + unknowns * (540 + 170 / mesh_size);
}

} // namespace

Estimate estimate_cost(const pfv::Case& problem, double mesh_size) {
  const pfv::PeriodicAxes periodic = periodic_axes(problem.faces);
  const pfv::Packing packing = meshing::with_images(problem.packing, periodic).packing;
  const double bridge_radius = meshing::MeshSettings{}.bridge_radius;
  const double elements =
      volume_in_elements(packing, meshing::ElementSize(problem.packing, mesh_size, bridge_radius, periodic));
  const double unknowns = unknowns_of(elements, mesh_size);
  return {unknowns, seconds_of(unknowns, mesh_size, static_cast<double>(packing.spheres.size())),
          bytes_of(unknowns, mesh_size)};
}

} // namespace reference::stokes_fem
