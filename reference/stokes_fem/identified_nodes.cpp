#include "reference/stokes_fem/identified_nodes.hpp"

#include "meshing/matching_points.hpp"
#include "pfv/problem/error.hpp"
#include "reference/stokes_fem/boundary_faces.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <numeric>

namespace reference::stokes_fem {

namespace {

using pfv::Vec3;
using Positions = std::map<unsigned, Vec3>; // of nodes on a face, by number

constexpr double tolerance = 1e-9; // of the longest side of the box

Vec3 as_vec3(const dealii::Point<3>& point) {
  return {point[0], point[1], point[2]};
}

/// The nodes on a face of the box that `nodes_of(cell, face number)` gives with their places.
template <class NodesOf>
Positions on_face(const Discretisation& space, pfv::Face face, const NodesOf& nodes_of) {
  Positions positions;
  for_each_boundary_face(space, [&](const Cell& cell, unsigned number, int label) {
    if (space.labels[static_cast<std::size_t>(label)] == BoundaryLabel(BoxFace{face}))
      nodes_of(cell, number, positions);
  });
  return positions;
}

/// Sets of numbers that are one, by their lowest.
class Unions {
public:
  explicit Unions(std::size_t size) : parent_(size) { std::iota(parent_.begin(), parent_.end(), 0U); }

  unsigned lowest(unsigned number) const {
    while (parent_[number] != number)
      number = parent_[number];
    return number;
  }
  void join(unsigned a, unsigned b) {
    a = lowest(a);
    b = lowest(b);
    parent_[std::max(a, b)] = std::min(a, b);
  }

private:
  std::vector<unsigned> parent_;
};

void join_opposite(const Positions& below, const Positions& above, pfv::Axis axis, const pfv::Box& box,
                   Unions& unions) {
  std::vector<Vec3> lowered, lower;
  std::vector<unsigned> upper_number, lower_number;
  for (const auto& [number, at] : above) {
    lowered.push_back(at - box.size()[index(axis)] * Vec3::Unit(index(axis)));
    upper_number.push_back(number);
  }
  for (const auto& [number, at] : below) {
    lower.push_back(at);
    lower_number.push_back(number);
  }
  const auto match = meshing::matching_points(lowered, lower, tolerance);
  for (std::size_t i = 0; i < match.size(); ++i) {
    if (match[i] < 0 || lower.size() != lowered.size())
      throw pfv::SolveError("the meshes of the periodic faces across " +
                            std::string(pfv::axis_names[static_cast<std::size_t>(index(axis))]) + " do not match");
    unions.join(upper_number[i], lower_number[static_cast<std::size_t>(match[i])]);
  }
}

template <class NodesOf>
std::vector<unsigned> identified(const Discretisation& space, const pfv::Box& box, const pfv::PeriodicAxes& periodic,
                                 std::size_t count, const NodesOf& nodes_of) {
  Unions unions(count);
  for (const pfv::Axis axis : {pfv::Axis::x, pfv::Axis::y, pfv::Axis::z})
    if (periodic[static_cast<std::size_t>(index(axis))])
      join_opposite(on_face(space, pfv::lower_face(axis), nodes_of), on_face(space, pfv::upper_face(axis), nodes_of),
                    axis, box, unions);
  std::vector<unsigned> numbers(count);
  for (unsigned i = 0; i < count; ++i)
    numbers[i] = unions.lowest(i);
  return numbers;
}

/// Without gaps; returns how many there are.
std::size_t renumber(std::vector<unsigned>& numbers) {
  std::size_t count = 0;
  for (unsigned i = 0; i < numbers.size(); ++i)
    numbers[i] = numbers[i] == i ? static_cast<unsigned>(count++) : numbers[numbers[i]];
  return count;
}

/// Of the nodes of a cell, which lie at `points`, those on one of its faces.
template <class Points>
void add_nodes_on_face(const dealii::DoFHandler<3>& space, const Cell& cell, unsigned number, const Points& points,
                       Positions& positions) {
  const auto here = cell_of(space, cell);
  Dofs nodes(points.size()), on_it(space.get_fe().n_dofs_per_face(number));
  here->get_dof_indices(nodes);
  here->face(number)->get_dof_indices(on_it);
  for (std::size_t i = 0; i < nodes.size(); ++i)
    if (std::ranges::find(on_it, nodes[i]) != on_it.end())
      positions[static_cast<unsigned>(nodes[i])] = as_vec3(points[i]);
}

} // namespace

std::vector<unsigned> identified_vertices(const Discretisation& space, const pfv::Box& box,
                                          const pfv::PeriodicAxes& periodic) {
  return identified(space, box, periodic, space.mesh.n_vertices(),
                    [](const Cell& cell, unsigned number, Positions& positions) {
                      for (unsigned v = 0; v < 3; ++v)
                        positions[cell->face(number)->vertex_index(v)] = as_vec3(cell->face(number)->vertex(v));
                    });
}

void identify_nodes(Discretisation& space, const pfv::Box& box, const pfv::PeriodicAxes& periodic) {
  space.velocity_node = identified(
      space, box, periodic, space.velocity.n_dofs(), [&](const Cell& cell, unsigned number, Positions& positions) {
        add_nodes_on_face(space.velocity, cell, number, space.mapping->points(cell), positions);
      });
  space.pressure_node = identified(space, box, periodic, space.pressure.n_dofs(),
                                   [&](const Cell& cell, unsigned number, Positions& positions) {
                                     std::array<dealii::Point<3>, 4> corners;
                                     for (unsigned v = 0; v < 4; ++v)
                                       corners[v] = cell->vertex(v);
                                     add_nodes_on_face(space.pressure, cell, number, corners, positions);
                                   });
  space.velocity_nodes = renumber(space.velocity_node);
  space.pressure_nodes = renumber(space.pressure_node);
}

} // namespace reference::stokes_fem
