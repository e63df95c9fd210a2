#pragma once

#include "reference/openfoam/foam_mesh.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace reference::openfoam {

/// Which cell a point is in. Faces of polyhedra are not quite flat and the mesh's spheres have facets, so a point may
/// be in none or in two: the cell it is least outside of is taken.
class CellSearch {
public:
  explicit CellSearch(const FoamMesh& mesh);

  /// The cell whose faces leave the point inside, or outside by the least and by no more than half of the size of the
  /// cell; nothing when there is none. Lengths in the unit of the mesh.
  std::optional<std::size_t> cell_of(const pfv::Vec3& point) const;

  /// Its faces; a face's normal points out of its owner.
  std::span<const std::size_t> faces_of(std::size_t cell) const {
    return std::span(faces_).subspan(first_face_[cell], first_face_[cell + 1] - first_face_[cell]);
  }

private:
  struct Plane {
    pfv::Vec3 centre;
    pfv::Vec3 normal; // of unit length, out of the owner
  };
  std::array<int, 3> bin_of(const pfv::Vec3& point) const;
  std::size_t place(int x, int y, int z) const {
    return (static_cast<std::size_t>(z) * bins_[1] + static_cast<std::size_t>(y)) * bins_[0] +
           static_cast<std::size_t>(x);
  }
  double outside(std::size_t cell, const pfv::Vec3& point) const;

  const FoamMesh& mesh_;
  std::vector<Plane> planes_;           // by face
  std::vector<std::size_t> faces_;      // of all cells, one after the other
  std::vector<std::size_t> first_face_; // by cell, and the end of the last
  std::vector<double> size_;            // by cell, of its bounding box
  pfv::Vec3 lower_, bin_size_;
  std::array<std::size_t, 3> bins_;
  std::vector<std::size_t> in_bin_;       // cells whose bounding box reaches into a bin, bin after bin
  std::vector<std::size_t> first_in_bin_; // by bin, and the end of the last
};

} // namespace reference::openfoam
