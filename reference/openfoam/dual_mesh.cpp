#include "reference/openfoam/dual_mesh.hpp"

#include "pfv/problem/error.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <limits>
#include <map>
#include <tuple>
#include <utility>

namespace reference::openfoam {

namespace {

constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

using Edge = std::pair<std::size_t, std::size_t>; // points, the smaller first

Edge edge(std::size_t a, std::size_t b) {
  return std::minmax(a, b);
}

struct DualFace {
  std::vector<std::size_t> points;
  std::size_t owner;
  std::size_t neighbour; // none on a patch
  std::size_t patch;     // none in the interior
};

class Dual {
public:
  explicit Dual(const FoamMesh& mesh) : mesh_(mesh), patch_of_(mesh.faces() - mesh.neighbour.size(), none) {
    for (std::size_t patch = 0; patch < mesh.patches.size(); ++patch)
      for (std::size_t k = 0; k < mesh.patches[patch].faces; ++k)
        patch_of_[mesh.patches[patch].first - mesh.neighbour.size() + k] = patch;
    points_ = mesh.cell_centres;
    for (std::size_t face = mesh.neighbour.size(); face < mesh.faces(); ++face)
      points_.push_back(mesh.centre(face));
  }

  FoamMesh made() {
    find_boundary_edges();
    add_faces_of_edges();
    add_boundary();
    return sorted();
  }

private:
  std::size_t point_of_boundary(std::size_t face) const { return mesh_.cells() + face - mesh_.neighbour.size(); }
  std::size_t patch(std::size_t face) const { return patch_of_[face - mesh_.neighbour.size()]; }

  // Edges between two patches keep their middle.
  void find_boundary_edges() {
    std::map<Edge, std::pair<std::size_t, int>> first; // patch, how many faces
    for (std::size_t face = mesh_.neighbour.size(); face < mesh_.faces(); ++face) {
      const auto corners = mesh_.face(face);
      for (std::size_t k = 0; k < corners.size(); ++k) {
        const std::size_t a = corners[k], b = corners[(k + 1) % corners.size()];
        auto [found, added] = first.try_emplace(edge(a, b), patch(face), 0);
        if (++found->second.second > 2)
          throw pfv::SolveError("the boundary of the mesh has an edge with more than two faces");
        if (!added && found->second.first != patch(face)) {
          middle_[edge(a, b)] = points_.size();
          points_.push_back((mesh_.points[a] + mesh_.points[b]) / 2);
        }
      }
    }
  }

  // The cells and boundary faces around each edge, in order.
  void add_faces_of_edges() {
    struct Link {
      std::size_t first, second; // points of the dual
    };
    std::map<Edge, std::vector<Link>> links;
    for (std::size_t face = 0; face < mesh_.faces(); ++face) {
      const auto corners = mesh_.face(face);
      const Link link{mesh_.owner[face],
                      face < mesh_.neighbour.size() ? mesh_.neighbour[face] : point_of_boundary(face)};
      for (std::size_t k = 0; k < corners.size(); ++k)
        links[edge(corners[k], corners[(k + 1) % corners.size()])].push_back(link);
    }
    for (auto& [ends, around] : links) {
      DualFace dual{{}, ends.first, ends.second, none};
      // From one boundary face to the other, or all around.
      auto start = std::ranges::find_if(around, [&](const Link& link) { return link.second >= mesh_.cells(); });
      const bool open = start != around.end();
      if (!open)
        start = around.begin();
      std::size_t here = open ? start->first : start->second;
      dual.points.push_back(open ? start->second : start->first);
      const std::size_t last = dual.points.front();
      std::iter_swap(start, around.end() - 1);
      around.pop_back();
      while (!around.empty()) {
        dual.points.push_back(here);
        const auto next =
            std::ranges::find_if(around, [&](const Link& link) { return link.first == here || link.second == here; });
        if (next == around.end())
          throw pfv::SolveError("the cells around an edge of the mesh are not connected");
        here = next->first == here ? next->second : next->first;
        std::iter_swap(next, around.end() - 1);
        around.pop_back();
      }
      if (open) {
        dual.points.push_back(here);
        if (const auto middle = middle_.find(ends); middle != middle_.end())
          dual.points.push_back(middle->second);
      } else if (here != last) {
        throw pfv::SolveError("the cells around an edge of the mesh do not close");
      }
      pfv::Vec3 area = pfv::Vec3::Zero();
      for (std::size_t k = 1; k + 1 < dual.points.size(); ++k)
        area += (points_[dual.points[k]] - points_[dual.points[0]])
                    .cross(points_[dual.points[k + 1]] - points_[dual.points[0]]);
      if (area.dot(mesh_.points[ends.second] - mesh_.points[ends.first]) < 0)
        std::ranges::reverse(dual.points);
      faces_.push_back(std::move(dual));
    }
  }

  // Around each point of the boundary, from one edge between patches to the next, or all around.
  void add_boundary() {
    struct Corner {
      std::size_t face, next, previous;
    };
    std::map<std::size_t, std::vector<Corner>> corners_of;
    for (std::size_t face = mesh_.neighbour.size(); face < mesh_.faces(); ++face) {
      const auto corners = mesh_.face(face);
      const std::size_t n = corners.size();
      for (std::size_t k = 0; k < n; ++k)
        corners_of[corners[k]].push_back({face, corners[(k + 1) % n], corners[(k + n - 1) % n]});
    }
    for (auto& [point, corners] : corners_of) {
      const auto middle = [&, point = point](std::size_t other) {
        const auto found = middle_.find(edge(point, other));
        return found == middle_.end() ? none : found->second;
      };
      std::size_t own = none;
      while (!corners.empty()) {
        auto here = std::ranges::find_if(corners, [&](const Corner& corner) { return middle(corner.next) != none; });
        const bool open = here != corners.end();
        if (!open)
          here = corners.begin();
        DualFace dual{{}, point, none, patch(here->face)};
        if (open) {
          if (own == none) {
            own = points_.size();
            points_.push_back(mesh_.points[point]);
          }
          dual.points = {own, middle(here->next)};
        }
        while (true) {
          dual.points.push_back(point_of_boundary(here->face));
          const std::size_t previous = here->previous;
          std::iter_swap(here, corners.end() - 1);
          corners.pop_back();
          if (middle(previous) != none) {
            dual.points.push_back(middle(previous));
            break;
          }
          here = std::ranges::find(corners, previous, &Corner::next);
          if (here == corners.end())
            break;
        }
        faces_.push_back(std::move(dual));
      }
    }
  }

  FoamMesh sorted() {
    std::ranges::stable_sort(faces_, {}, [](const DualFace& face) {
      return face.patch == none ? std::tuple(std::size_t{0}, face.owner, face.neighbour)
                                : std::tuple(face.patch + 1, face.owner, std::size_t{0});
    });
    FoamMesh mesh;
    mesh.points = std::move(points_);
    mesh.patches = mesh_.patches;
    for (MeshPatch& patch : mesh.patches)
      patch.faces = 0;
    for (const DualFace& face : faces_) {
      mesh.add_face(face.points);
      mesh.owner.push_back(face.owner);
      if (face.patch == none)
        mesh.neighbour.push_back(face.neighbour);
      else
        ++mesh.patches[face.patch].faces;
    }
    std::size_t first = mesh.neighbour.size();
    for (MeshPatch& patch : mesh.patches) {
      patch.first = first;
      first += patch.faces;
    }
    mesh.cell_centres = cell_centres(mesh);
    return mesh;
  }

  const FoamMesh& mesh_;
  std::vector<std::size_t> patch_of_;  // by boundary face
  std::vector<pfv::Vec3> points_;      // of the dual
  std::map<Edge, std::size_t> middle_; // point of the dual, of edges between patches
  std::vector<DualFace> faces_;
};

} // namespace

FoamMesh dual_mesh(const FoamMesh& tetrahedra) {
  return Dual(tetrahedra).made();
}

} // namespace reference::openfoam
