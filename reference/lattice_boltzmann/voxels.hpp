#pragma once

#include "reference/lattice_boltzmann/flow_question.hpp"

#include <cstdint>

namespace reference::lattice_boltzmann {

/// A sphere of the packing where it or one of its images across the faces of the box stands.
struct SphereImage {
  pfv::Vec3 centre;
  double radius;
  std::int32_t sphere;
};

/// The images that come within a voxel of the box, the spheres themselves among them.
std::vector<SphereImage> sphere_images(const FlowQuestion& question);

/// Which voxels have their centre in a sphere, and in which.
class Voxels {
public:
  static constexpr std::int32_t fluid = -1;

  explicit Voxels(const FlowQuestion& question);

  const std::array<int, 3>& size() const { return size_; }
  std::size_t index(const std::array<int, 3>& voxel) const {
    return (static_cast<std::size_t>(voxel[0]) * static_cast<std::size_t>(size_[1]) +
            static_cast<std::size_t>(voxel[1])) *
               static_cast<std::size_t>(size_[2]) +
           static_cast<std::size_t>(voxel[2]);
  }
  bool inside(const std::array<int, 3>& voxel) const;
  /// The voxel of the box that one up to a box away is an image of.
  std::array<int, 3> image(std::array<int, 3> voxel) const;
  /// The sphere at a voxel of the box; the one whose radical plane it is behind where they overlap.
  std::int32_t owner(const std::array<int, 3>& voxel) const { return owner_[index(voxel)]; }
  bool is_fluid(const std::array<int, 3>& voxel) const { return owner(voxel) == fluid; }
  void give(const std::array<int, 3>& voxel, std::int32_t sphere) { owner_[index(voxel)] = sphere; }
  std::size_t fluid_count() const;
  /// By sphere.
  std::vector<double> solid_counts(std::size_t spheres) const;

private:
  std::array<int, 3> size_;
  std::array<Beyond, 3> beyond_;
  std::vector<std::int32_t> owner_;
};

} // namespace reference::lattice_boltzmann
