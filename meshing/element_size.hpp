#pragma once

#include "pfv/problem/packing.hpp"

#include <array>
#include <vector>

namespace meshing {

/// Element length wanted at a point of the void:
///   h = mesh_size clamp(gap_fraction (d1 + d2), smallest r, min_k(largest r_k + growth d_k)),
/// d1, d2 the distances to the two nearest solid surfaces, mirror images in the box faces included (a slip wall halves
/// a gap), r the smaller of their radii. So a gap is crossed by a number of elements that does not depend on its width
/// until it is as thin as the rim of a bridge.
class ElementSize {
public:
  static constexpr double gap_fraction = 0.5;
  static constexpr double smallest = 0.1; // of the radius
  static constexpr double largest = 0.28; // of the radius, on its surface
  static constexpr double growth = 0.25;  // m per m away from it

  ElementSize(const pfv::Packing& packing, double mesh_size);

  /// Element length in m at a point in m.
  double operator()(const pfv::Vec3& point) const;

private:
  std::array<int, 3> cell_of(const pfv::Vec3& point) const;
  std::size_t place(const std::array<int, 3>& cell) const;
  std::vector<int> near(const std::array<int, 3>& cell, const std::vector<std::vector<int>>& centred,
                        double largest_radius) const;

  double mesh_size_;
  pfv::Vec3 lower_;
  pfv::Vec3 cell_size_;
  std::array<int, 3> cells_;
  std::vector<pfv::Sphere> surfaces_;           // the spheres and their mirror images
  std::vector<std::vector<int>> cell_surfaces_; // those that can be among the two nearest of a point in the cell
};

} // namespace meshing
