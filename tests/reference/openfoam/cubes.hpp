#pragma once

#include "reference/openfoam/foam_mesh.hpp"

#include <array>

namespace reference::openfoam {

/// The unit cube as n^3 hexahedra, one patch for each face of the box.
inline FoamMesh cubes(std::size_t n) {
  FoamMesh mesh;
  const auto point = [n](std::size_t x, std::size_t y, std::size_t z) { return (z * (n + 1) + y) * (n + 1) + x; };
  const auto cell = [n](const std::array<std::size_t, 3>& at) { return (at[2] * n + at[1]) * n + at[0]; };
  for (std::size_t z = 0; z <= n; ++z)
    for (std::size_t y = 0; y <= n; ++y)
      for (std::size_t x = 0; x <= n; ++x)
        mesh.points.push_back(pfv::Vec3(double(x), double(y), double(z)) / double(n));
  // The face of a cell across an axis on its upper side; turned round on its lower side.
  const auto add_face = [&](std::array<std::size_t, 3> at, std::size_t axis, bool upper) {
    const std::size_t owner = cell(at);
    at[axis] += upper ? 1 : 0;
    std::array<std::size_t, 4> corners{};
    for (std::size_t k = 0; k < 4; ++k) {
      auto corner = at;
      corner[(axis + 1) % 3] += k == 1 || k == 2 ? 1 : 0;
      corner[(axis + 2) % 3] += k >= 2 ? 1 : 0;
      corners[upper ? k : 3 - k] = point(corner[0], corner[1], corner[2]);
    }
    mesh.add_face(corners);
    mesh.owner.push_back(owner);
  };
  const auto for_each_cell = [&](const auto& visit) {
    for (std::size_t z = 0; z < n; ++z)
      for (std::size_t y = 0; y < n; ++y)
        for (std::size_t x = 0; x < n; ++x)
          visit(std::array{x, y, z});
  };
  for_each_cell([&](const std::array<std::size_t, 3>& at) {
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (at[axis] + 1 < n) {
        auto next = at;
        ++next[axis];
        add_face(at, axis, true);
        mesh.neighbour.push_back(cell(next));
      }
  });
  for (const pfv::Face face : pfv::all_faces) {
    const auto axis = static_cast<std::size_t>(pfv::index(pfv::axis_of(face)));
    const std::size_t first = mesh.faces();
    for_each_cell([&](const std::array<std::size_t, 3>& at) {
      if (at[axis] == (pfv::is_upper(face) ? n - 1 : 0))
        add_face(at, axis, pfv::is_upper(face));
    });
    const std::string name(pfv::face_names[static_cast<std::size_t>(pfv::index(face))]);
    mesh.patches.push_back({name, face, first, mesh.faces() - first});
  }
  mesh.cell_centres = cell_centres(mesh);
  return mesh;
}

} // namespace reference::openfoam
