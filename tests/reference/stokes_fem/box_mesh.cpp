#include "reference/stokes_fem/box_mesh.hpp"

#include <algorithm>
#include <fstream>
#include <vector>

namespace {

using Lattice = std::array<int, 3>; // integer coordinates of a node

struct Grid {
  Lattice cells;

  int node(const Lattice& at) const { return 1 + at[0] + (cells[0] + 1) * (at[1] + (cells[1] + 1) * at[2]); }
};

// The six tetrahedra of a brick share its diagonal: one per order in which the three axes are walked.
std::vector<std::array<Lattice, 4>> tetrahedra(const Grid& grid) {
  std::vector<std::array<Lattice, 4>> list;
  for (int k = 0; k < grid.cells[2]; ++k)
    for (int j = 0; j < grid.cells[1]; ++j)
      for (int i = 0; i < grid.cells[0]; ++i) {
        std::array<int, 3> axes{0, 1, 2};
        do {
          std::array<Lattice, 4> corner;
          corner.fill({i, j, k});
          for (std::size_t step = 1; step < 4; ++step) {
            corner[step] = corner[step - 1];
            ++corner[step][static_cast<std::size_t>(axes[step - 1])];
          }
          const bool even = (axes[1] - axes[0] + 3) % 3 == 1;
          if (!even)
            std::swap(corner[1], corner[2]);
          list.push_back(corner);
        } while (std::ranges::next_permutation(axes).found);
      }
  return list;
}

struct Triangle {
  int group;
  std::array<Lattice, 3> corner;
};

std::vector<Triangle> boundary(const Grid& grid, const std::vector<std::array<Lattice, 4>>& cells) {
  std::vector<Triangle> list;
  for (const auto& cell : cells)
    for (std::size_t opposite = 0; opposite < 4; ++opposite) {
      std::array<Lattice, 3> corner;
      for (std::size_t v = 0, next = 0; v < 4; ++v)
        if (v != opposite)
          corner[next++] = cell[v];
      for (std::size_t face = 0; face < 6; ++face) {
        const int position = face % 2 == 0 ? 0 : grid.cells[face / 2];
        if (std::ranges::all_of(corner, [&](const Lattice& at) { return at[face / 2] == position; }))
          list.push_back({static_cast<int>(face) + 1, corner});
      }
    }
  return list;
}

} // namespace

void write_box_mesh(const std::filesystem::path& file, const pfv::Box& box, const std::array<int, 3>& cells,
                    const std::array<std::string, 6>& groups) {
  const Grid grid{cells};
  const auto volumes = tetrahedra(grid);
  const auto triangles = boundary(grid, volumes);
  std::ofstream out(file);
  out.precision(17);
  out << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n7\n";
  for (std::size_t face = 0; face < 6; ++face)
    out << "2 " << face + 1 << " \"" << groups[face] << "\"\n";
  out << "3 7 \"fluid\"\n$EndPhysicalNames\n$Nodes\n" << (cells[0] + 1) * (cells[1] + 1) * (cells[2] + 1) << "\n";
  for (int k = 0; k <= cells[2]; ++k)
    for (int j = 0; j <= cells[1]; ++j)
      for (int i = 0; i <= cells[0]; ++i) {
        const pfv::Vec3 fraction(double(i) / cells[0], double(j) / cells[1], double(k) / cells[2]);
        const pfv::Vec3 at = box.lower + fraction.cwiseProduct(box.size());
        out << grid.node({i, j, k}) << " " << at[0] << " " << at[1] << " " << at[2] << "\n";
      }
  out << "$EndNodes\n$Elements\n" << triangles.size() + volumes.size() << "\n";
  std::size_t element = 0;
  for (const Triangle& triangle : triangles) {
    out << ++element << " 2 2 " << triangle.group << " " << triangle.group;
    for (const Lattice& at : triangle.corner)
      out << " " << grid.node(at);
    out << "\n";
  }
  for (const auto& cell : volumes) {
    out << ++element << " 4 2 7 7";
    for (const Lattice& at : cell)
      out << " " << grid.node(at);
    out << "\n";
  }
  out << "$EndElements\n";
}
