#pragma once

#include "pfv/problem/packing.hpp"

#include <array>
#include <vector>

namespace meshing {

/// Element length wanted at a point of the void, by the distances d1 <= d2 <= d3 to the three nearest solid surfaces,
/// mirror images in the box faces included (a slip wall halves a gap), or those in the next box where it is periodic:
///   h = mesh_size clamp(fraction (d1 + d2), floor, cap).
/// A gap is crossed by the same number of elements whatever its width, down to the floor. Between two surfaces alone,
/// near a contact, next to nothing flows and the floor is high; a third one makes it a throat, and the floor is lower
/// there:
///   floor = r min(max(fraction d3 / r, smallest), contact, rim bridge_radius / mesh_size), r the smaller radius of the
///   first two;
/// the last leaves at least four elements around the rim of a bridge, and lets meshes of mesh_size up to 1.2 be scaled
/// versions of each other, without which there is nothing to extrapolate from. Far from everything elements may grow:
///   cap = min(largest r_k + growth d_k), k the first two.
/// Chosen by the error of the permeability by quadratic elements for a given number of unknowns: simple cubic, bcc and
/// fcc at contact -0.6, -0.6 and -0.8 %, nine spheres -0.5 % with 2e5 unknowns, at mesh_size 1.
class ElementSize {
public:
  static constexpr double fraction = 0.3;
  static constexpr double smallest = 0.06; // of the radius
  static constexpr double contact = 0.18;  // of the radius
  static constexpr double rim = 1.45;      // of the bridge's radius
  static constexpr double largest = 0.3;   // of the radius
  static constexpr double growth = 0.25;   // m per m

  ElementSize(const pfv::Packing& packing, double mesh_size, double bridge_radius = 0.15,
              const pfv::PeriodicAxes& periodic = {});

  /// Element length in m at a point in m.
  double operator()(const pfv::Vec3& point) const;

private:
  std::array<int, 3> cell_of(const pfv::Vec3& point) const;
  std::size_t place(const std::array<int, 3>& cell) const;
  std::vector<int> near(const std::array<int, 3>& cell, const std::vector<std::vector<int>>& centred,
                        double largest_radius) const;

  double mesh_size_;
  double highest_floor_; // of the radius
  pfv::Vec3 lower_;
  pfv::Vec3 cell_size_;
  std::array<int, 3> cells_;
  std::vector<pfv::Sphere> surfaces_;           // the spheres and their images
  std::vector<std::vector<int>> cell_surfaces_; // those that can be among the three nearest of a point in the cell
};

} // namespace meshing
