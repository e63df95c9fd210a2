#pragma once

#include "reference/stokes_fem/flow_mesh.hpp"

#include <memory>
#include <optional>
#include <vector>

namespace reference::stokes_fem {

/// Finds the cells of a mesh at a place, by a tree of their bounding boxes. Keeps a reference to the mesh.
class CellSearch {
public:
  explicit CellSearch(const FlowMesh& mesh);
  ~CellSearch();
  CellSearch(const CellSearch&) = delete;
  CellSearch& operator=(const CellSearch&) = delete;

  struct Place {
    std::size_t cell;
    Weights weights; // not below zero by more than 0.05
  };
  /// The cell that holds a point, or else one that misses it by a twentieth of its size: curved cells stop short of the
  /// exact surface, or go beyond it, by less.
  std::optional<Place> find(const pfv::Vec3& point) const;
  /// Cells whose bounding boxes meet the axis-aligned box.
  std::vector<std::size_t> near(const pfv::Vec3& lower, const pfv::Vec3& upper) const;

private:
  struct Tree;
  const FlowMesh& mesh_;
  std::unique_ptr<Tree> tree_;
};

} // namespace reference::stokes_fem
