#include "reference/openfoam/cell_search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace reference::openfoam {

namespace {

struct Bounds {
  pfv::Vec3 lower = pfv::Vec3::Constant(std::numeric_limits<double>::infinity());
  pfv::Vec3 upper = -lower;
};

// Turns counts by place into where each place begins, and the end of the last.
void sum_up(std::vector<std::size_t>& counts) {
  counts.push_back(0);
  std::exclusive_scan(counts.begin(), counts.end(), counts.begin(), std::size_t{0});
}

std::vector<Bounds> bounds_of_cells(const FoamMesh& mesh) {
  std::vector<Bounds> bounds(mesh.cells());
  const auto widen = [&](std::size_t cell, std::size_t face) {
    for (const std::size_t corner : mesh.face(face)) {
      bounds[cell].lower = bounds[cell].lower.cwiseMin(mesh.points[corner]);
      bounds[cell].upper = bounds[cell].upper.cwiseMax(mesh.points[corner]);
    }
  };
  for (std::size_t face = 0; face < mesh.faces(); ++face) {
    widen(mesh.owner[face], face);
    if (face < mesh.neighbour.size())
      widen(mesh.neighbour[face], face);
  }
  return bounds;
}

} // namespace

CellSearch::CellSearch(const FoamMesh& mesh) : mesh_(mesh), first_face_(mesh.cells()) {
  for (std::size_t face = 0; face < mesh.faces(); ++face) {
    planes_.push_back({mesh.centre(face), mesh.area(face).normalized()});
    ++first_face_[mesh.owner[face]];
    if (face < mesh.neighbour.size())
      ++first_face_[mesh.neighbour[face]];
  }
  sum_up(first_face_);
  faces_.resize(first_face_.back());
  auto next = first_face_;
  for (std::size_t face = 0; face < mesh.faces(); ++face) {
    faces_[next[mesh.owner[face]]++] = face;
    if (face < mesh.neighbour.size())
      faces_[next[mesh.neighbour[face]]++] = face;
  }

  const auto bounds = bounds_of_cells(mesh);
  Bounds all;
  for (const auto& [lower, upper] : bounds) {
    all.lower = all.lower.cwiseMin(lower);
    all.upper = all.upper.cwiseMax(upper);
    size_.push_back((upper - lower).maxCoeff());
  }
  lower_ = all.lower;
  const pfv::Vec3 extent = all.upper - all.lower;
  const double side = std::cbrt(extent.prod() / static_cast<double>(mesh.cells()));
  for (int axis = 0; axis < 3; ++axis) {
    const auto a = static_cast<std::size_t>(axis);
    bins_[a] = std::clamp<std::size_t>(static_cast<std::size_t>(extent[axis] / side), 1, 500);
    bin_size_[axis] = extent[axis] / static_cast<double>(bins_[a]);
  }
  const auto for_each_bin = [&](const Bounds& cell, const auto& visit) {
    const pfv::Vec3 margin = 0.25 * (cell.upper - cell.lower);
    const auto from = bin_of(cell.lower - margin), to = bin_of(cell.upper + margin);
    for (int z = from[2]; z <= to[2]; ++z)
      for (int y = from[1]; y <= to[1]; ++y)
        for (int x = from[0]; x <= to[0]; ++x)
          visit(place(x, y, z));
  };
  first_in_bin_.resize(bins_[0] * bins_[1] * bins_[2]);
  for (const Bounds& cell : bounds)
    for_each_bin(cell, [&](std::size_t bin) { ++first_in_bin_[bin]; });
  sum_up(first_in_bin_);
  in_bin_.resize(first_in_bin_.back());
  next = first_in_bin_;
  for (std::size_t cell = 0; cell < bounds.size(); ++cell)
    for_each_bin(bounds[cell], [&](std::size_t bin) { in_bin_[next[bin]++] = cell; });
}

std::array<int, 3> CellSearch::bin_of(const pfv::Vec3& point) const {
  std::array<int, 3> bin{};
  for (int axis = 0; axis < 3; ++axis) {
    const auto a = static_cast<std::size_t>(axis);
    bin[a] = static_cast<int>(
        std::clamp(std::floor((point[axis] - lower_[axis]) / bin_size_[axis]), 0.0, static_cast<double>(bins_[a] - 1)));
  }
  return bin;
}

double CellSearch::outside(std::size_t cell, const pfv::Vec3& point) const {
  double farthest = -std::numeric_limits<double>::infinity();
  for (const std::size_t face : faces_of(cell)) {
    const double distance = planes_[face].normal.dot(point - planes_[face].centre);
    farthest = std::max(farthest, mesh_.owner[face] == cell ? distance : -distance);
  }
  return farthest;
}

std::optional<std::size_t> CellSearch::cell_of(const pfv::Vec3& point) const {
  const auto [x, y, z] = bin_of(point);
  std::optional<std::size_t> best;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = first_in_bin_[place(x, y, z)]; k < first_in_bin_[place(x, y, z) + 1]; ++k) {
    const std::size_t cell = in_bin_[k];
    const double distance = outside(cell, point);
    if (distance < std::min(least, size_[cell] / 2)) {
      least = distance;
      best = cell;
    }
    if (least <= 0)
      break;
  }
  return best;
}

} // namespace reference::openfoam
