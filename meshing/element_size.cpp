#include "meshing/element_size.hpp"

#include "meshing/periodic_images.hpp"
#include "pfv/problem/face.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace meshing {

namespace {

/// The spheres, their periodic images and the images of all these in the other faces; an image that falls on its own
/// sphere is the same surface.
std::vector<pfv::Sphere> surfaces_of(const pfv::Packing& packing, const pfv::PeriodicAxes& periodic) {
  std::vector<pfv::Sphere> surfaces = all_images(packing, periodic);
  const std::vector<pfv::Sphere> spheres = surfaces;
  for (const auto& [centre, radius] : spheres)
    for (const pfv::Face face : pfv::all_faces) {
      const int axis = pfv::index(pfv::axis_of(face));
      if (periodic[static_cast<std::size_t>(axis)])
        continue;
      const double plane = (pfv::is_upper(face) ? packing.box.upper : packing.box.lower)[axis];
      if (std::abs(plane - centre[axis]) < 1e-6 * radius)
        continue;
      pfv::Vec3 image = centre;
      image[axis] = 2 * plane - centre[axis];
      surfaces.push_back({image, radius});
    }
  return surfaces;
}

double distance_to(const pfv::Sphere& surface, const pfv::Vec3& point) {
  return std::max(0.0, (point - surface.centre).norm() - surface.radius);
}

} // namespace

ElementSize::ElementSize(const pfv::Packing& packing, double mesh_size, double bridge_radius,
                         const pfv::PeriodicAxes& periodic)
    : mesh_size_(mesh_size), highest_floor_(std::min(contact, rim * bridge_radius / mesh_size)),
      lower_(packing.box.lower), surfaces_(surfaces_of(packing, periodic)) {
  const double spacing = std::cbrt(packing.box.volume() / (8.0 * static_cast<double>(packing.spheres.size())));
  for (int a = 0; a < 3; ++a) {
    cells_[a] = std::clamp(static_cast<int>(packing.box.size()[a] / spacing), 1, 64);
    cell_size_[a] = packing.box.size()[a] / cells_[a];
  }
  std::vector<std::vector<int>> centred(static_cast<std::size_t>(cells_[0] * cells_[1] * cells_[2]));
  double largest_radius = 0;
  for (std::size_t i = 0; i < surfaces_.size(); ++i) {
    centred[place(cell_of(surfaces_[i].centre))].push_back(static_cast<int>(i));
    largest_radius = std::max(largest_radius, surfaces_[i].radius);
  }
  cell_surfaces_.reserve(centred.size());
  for (int z = 0; z < cells_[2]; ++z)
    for (int y = 0; y < cells_[1]; ++y)
      for (int x = 0; x < cells_[0]; ++x)
        cell_surfaces_.push_back(near({x, y, z}, centred, largest_radius));
}

std::array<int, 3> ElementSize::cell_of(const pfv::Vec3& point) const {
  std::array<int, 3> cell{};
  for (int a = 0; a < 3; ++a)
    cell[a] = std::clamp(static_cast<int>((point[a] - lower_[a]) / cell_size_[a]), 0, cells_[a] - 1);
  return cell;
}

std::size_t ElementSize::place(const std::array<int, 3>& cell) const {
  return static_cast<std::size_t>((cell[2] * cells_[1] + cell[1]) * cells_[0] + cell[0]);
}

/// Surfaces that can be among the three nearest of a point in the cell, found shell by shell of cells around it until
/// the next shell is too far.
std::vector<int> ElementSize::near(const std::array<int, 3>& cell, const std::vector<std::vector<int>>& centred,
                                   double largest_radius) const {
  const pfv::Vec3 middle = lower_ + cell_size_.cwiseProduct(pfv::Vec3(cell[0] + 0.5, cell[1] + 0.5, cell[2] + 0.5));
  const int last_shell = *std::ranges::max_element(cells_);
  std::vector<std::pair<double, int>> found; // distance from the middle, surface
  double reach = std::numeric_limits<double>::infinity();
  for (int shell = 0; shell <= last_shell; ++shell) {
    if ((shell - 0.5) * cell_size_.minCoeff() - largest_radius > reach)
      break;
    std::array<int, 3> from{}, to{};
    for (int a = 0; a < 3; ++a) {
      from[a] = std::max(0, cell[a] - shell);
      to[a] = std::min(cells_[a] - 1, cell[a] + shell);
    }
    for (int z = from[2]; z <= to[2]; ++z)
      for (int y = from[1]; y <= to[1]; ++y)
        for (int x = from[0]; x <= to[0]; ++x)
          if (std::max({std::abs(x - cell[0]), std::abs(y - cell[1]), std::abs(z - cell[2])}) == shell)
            for (const int s : centred[place({x, y, z})])
              found.emplace_back(distance_to(surfaces_[static_cast<std::size_t>(s)], middle), s);
    if (found.size() > 2) {
      std::ranges::nth_element(found, found.begin() + 2);
      reach = found[2].first + cell_size_.norm(); // both the point and the middle can be half a diagonal off
    }
  }
  std::vector<int> kept;
  for (const auto& [distance, s] : found)
    if (distance <= reach)
      kept.push_back(s);
  std::ranges::sort(kept);
  return kept;
}

double ElementSize::operator()(const pfv::Vec3& point) const {
  struct Near {
    double distance = std::numeric_limits<double>::infinity();
    double radius = std::numeric_limits<double>::infinity();
  };
  std::array<Near, 3> nearest; // in order
  for (const int s : cell_surfaces_[place(cell_of(point))]) {
    Near here{distance_to(surfaces_[s], point), surfaces_[s].radius};
    for (Near& other : nearest)
      if (here.distance < other.distance)
        std::swap(here, other);
  }
  const auto& [first, second, third] = nearest;
  const double radius = std::min(first.radius, second.radius);
  const double cap =
      std::min(largest * first.radius + growth * first.distance, largest * second.radius + growth * second.distance);
  const double floor = std::min(std::max(fraction * third.distance, smallest * radius), highest_floor_ * radius);
  return mesh_size_ * std::min(cap, std::max(floor, fraction * (first.distance + second.distance)));
}

} // namespace meshing
