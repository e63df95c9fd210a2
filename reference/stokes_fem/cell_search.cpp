#include "reference/stokes_fem/cell_search.hpp"

#define BOOST_ALLOW_DEPRECATED_HEADERS // its own, which it warns of
#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/point.hpp>
#include <boost/geometry/index/rtree.hpp>

#include <iterator>

namespace reference::stokes_fem {

namespace {

namespace geometry = boost::geometry;
using Point = geometry::model::point<double, 3, geometry::cs::cartesian>;
using Box = geometry::model::box<Point>;
using Entry = std::pair<Box, std::size_t>;

constexpr double margin = 0.05; // of a cell

Point point_of(const pfv::Vec3& at) {
  return {at[0], at[1], at[2]};
}

} // namespace

struct CellSearch::Tree {
  geometry::index::rtree<Entry, geometry::index::quadratic<16>> boxes;

  std::vector<Entry> meeting(const pfv::Vec3& lower, const pfv::Vec3& upper) const {
    std::vector<Entry> found;
    boxes.query(geometry::index::intersects(Box(point_of(lower), point_of(upper))), std::back_inserter(found));
    return found;
  }
};

CellSearch::CellSearch(const FlowMesh& mesh) : mesh_(mesh) {
  std::vector<Entry> entries;
  entries.reserve(mesh.cells.size());
  for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell) {
    const auto [lower, upper] = mesh.cell(cell).bounds();
    const pfv::Vec3 more = pfv::Vec3::Constant(margin * (upper - lower).maxCoeff());
    entries.emplace_back(Box(point_of(lower - more), point_of(upper + more)), cell);
  }
  tree_ = std::make_unique<Tree>(Tree{decltype(Tree::boxes)(entries)});
}

CellSearch::~CellSearch() = default;

std::optional<CellSearch::Place> CellSearch::find(const pfv::Vec3& point) const {
  std::optional<Place> best;
  double least = -margin;
  for (const auto& [box, index] : tree_->meeting(point, point)) {
    const QuadraticCell cell = mesh_.cell(index);
    std::optional<Weights> weights = cell.straight_weights(point);
    if (mesh_.is_curved[index])
      weights = cell.weights_of(point, *weights);
    if (!weights || weights->minCoeff() < least)
      continue;
    least = weights->minCoeff();
    best = Place{index, *weights};
    if (least >= 0)
      break;
  }
  return best;
}

std::vector<std::size_t> CellSearch::near(const pfv::Vec3& lower, const pfv::Vec3& upper) const {
  std::vector<std::size_t> cells;
  for (const auto& [box, cell] : tree_->meeting(lower, upper))
    cells.push_back(cell);
  return cells;
}

} // namespace reference::stokes_fem
