#include "reference/openfoam/foam_mesh.hpp"

#include "pfv/problem/error.hpp"
#include "reference/openfoam/foam_reader.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <fstream>
#include <numbers>

namespace reference::openfoam {

namespace {

std::vector<pfv::Vec3> read_points(const std::filesystem::path& file) {
  FoamReader in(file);
  in.skip_header();
  std::vector<pfv::Vec3> points(in.count());
  in.expect('(');
  for (pfv::Vec3& point : points)
    point = in.vector();
  return points;
}

void read_faces(const std::filesystem::path& file, FoamMesh& mesh) {
  FoamReader in(file);
  in.skip_header();
  std::size_t faces = in.count();
  mesh.first_corner.reserve(faces + 1);
  in.expect('(');
  for (std::vector<std::size_t> face; faces > 0; --faces) {
    face = in.counts();
    if (face.size() < 3 || std::ranges::max(face) >= mesh.points.size())
      throw pfv::SolveError("OpenFOAM's mesh has a face without three points of the mesh");
    mesh.add_face(face);
  }
}

std::vector<std::size_t> read_cells(const std::filesystem::path& file) {
  FoamReader in(file);
  in.skip_header();
  return in.counts();
}

std::vector<MeshPatch> read_patches(const std::filesystem::path& file) {
  FoamReader in(file);
  in.skip_header();
  std::vector<MeshPatch> patches(in.count());
  in.expect('(');
  for (MeshPatch& patch : patches) {
    patch.name = in.word();
    patch.part = patch_named(patch.name);
    in.skip_past("nFaces");
    patch.faces = in.count();
    in.skip_past("startFace");
    patch.first = in.count();
    in.skip_past("}");
  }
  return patches;
}

} // namespace

void FoamMesh::add_face(std::span<const std::size_t> points_of_face) {
  corners.insert(corners.end(), points_of_face.begin(), points_of_face.end());
  first_corner.push_back(corners.size());
}

pfv::Vec3 FoamMesh::middle(std::size_t face) const {
  pfv::Vec3 sum = pfv::Vec3::Zero();
  for (const std::size_t corner : this->face(face))
    sum += points[corner];
  return sum / static_cast<double>(this->face(face).size());
}

pfv::Vec3 FoamMesh::centre(std::size_t face) const {
  const auto corners_of_face = this->face(face);
  const pfv::Vec3 top = middle(face);
  if (corners_of_face.size() == 3)
    return top;
  pfv::Vec3 sum = pfv::Vec3::Zero();
  double area = 0;
  for (std::size_t k = 0; k < corners_of_face.size(); ++k) {
    const pfv::Vec3 a = points[corners_of_face[k]], b = points[corners_of_face[(k + 1) % corners_of_face.size()]];
    const double part = (b - a).cross(top - a).norm();
    sum += part * (a + b + top) / 3;
    area += part;
  }
  return area > 0 ? pfv::Vec3(sum / area) : top;
}

pfv::Vec3 FoamMesh::area(std::size_t face) const {
  const auto corners_of_face = this->face(face);
  const pfv::Vec3& first = points[corners_of_face.front()];
  pfv::Vec3 sum = pfv::Vec3::Zero();
  for (std::size_t k = 1; k + 1 < corners_of_face.size(); ++k)
    sum += (points[corners_of_face[k]] - first).cross(points[corners_of_face[k + 1]] - first);
  return sum / 2;
}

std::vector<pfv::Vec3> cell_centres(const FoamMesh& mesh) {
  // The cell numbered last may own no face at all.
  const std::size_t cells = std::max(std::ranges::max(mesh.owner), std::ranges::max(mesh.neighbour)) + 1;
  std::vector<pfv::Vec3> tops(cells, pfv::Vec3::Zero()), sums(cells, pfv::Vec3::Zero());
  std::vector<double> faces(cells), volumes(cells);
  const auto for_each_side = [&](const auto& visit) {
    for (std::size_t face = 0; face < mesh.faces(); ++face) {
      const pfv::Vec3 centre = mesh.centre(face), area = mesh.area(face);
      visit(mesh.owner[face], centre, area);
      if (face < mesh.neighbour.size())
        visit(mesh.neighbour[face], centre, -area);
    }
  };
  for_each_side([&](std::size_t cell, const pfv::Vec3& centre, const pfv::Vec3&) {
    tops[cell] += centre;
    ++faces[cell];
  });
  for (std::size_t cell = 0; cell < cells; ++cell)
    tops[cell] /= faces[cell];
  for_each_side([&](std::size_t cell, const pfv::Vec3& centre, const pfv::Vec3& area) {
    const double volume = area.dot(centre - tops[cell]) / 3;
    sums[cell] += volume * (0.75 * centre + 0.25 * tops[cell]);
    volumes[cell] += volume;
  });
  for (std::size_t cell = 0; cell < cells; ++cell)
    tops[cell] = volumes[cell] > 0 ? pfv::Vec3(sums[cell] / volumes[cell]) : tops[cell];
  return tops;
}

double volume(const FoamMesh& mesh) {
  double sum = 0;
  for (std::size_t face = mesh.neighbour.size(); face < mesh.faces(); ++face)
    sum += mesh.centre(face).dot(mesh.area(face)) / 3;
  return sum;
}

FoamMesh read_mesh(const std::filesystem::path& case_folder) {
  const auto folder = case_folder / "constant" / "polyMesh";
  FoamMesh mesh;
  mesh.points = read_points(folder / "points");
  read_faces(folder / "faces", mesh);
  mesh.owner = read_cells(folder / "owner");
  mesh.neighbour = read_cells(folder / "neighbour");
  mesh.patches = read_patches(folder / "boundary");
  if (mesh.owner.size() != mesh.faces() || mesh.neighbour.empty())
    throw pfv::SolveError("OpenFOAM's mesh has no interior or an owner list of the wrong length");
  mesh.cell_centres = cell_centres(mesh);
  return mesh;
}

namespace {

// OpenFOAM's list of `size` items, written by `item(k)`.
template <class Item>
void write_list(const std::filesystem::path& file, std::string_view kind, std::size_t size, Item item) {
  std::ofstream out(file);
  out << "FoamFile { version 2.0; format ascii; class " << kind << "; object " << file.filename().string()
      << "; }\n// * * //\n"
      << size << "\n(\n";
  for (std::size_t k = 0; k < size; ++k)
    out << item(k) << '\n';
  out << ")\n";
  if (!out.flush())
    throw pfv::SolveError("cannot write " + file.string());
}

} // namespace

void write_points(const std::filesystem::path& case_folder, const FoamMesh& mesh) {
  write_list(case_folder / "constant" / "polyMesh" / "points", "vectorField", mesh.points.size(), [&](std::size_t k) {
    const pfv::Vec3& point = mesh.points[k];
    return fmt::format("({} {} {})", point.x(), point.y(), point.z());
  });
}

void write_mesh(const std::filesystem::path& case_folder, const FoamMesh& mesh) {
  const auto folder = case_folder / "constant" / "polyMesh";
  for (const char* zones : {"cellZones", "faceZones", "pointZones"})
    std::filesystem::remove(folder / zones);
  write_points(case_folder, mesh);
  write_list(folder / "faces", "faceList", mesh.faces(),
             [&](std::size_t k) { return fmt::format("{}({})", mesh.face(k).size(), fmt::join(mesh.face(k), " ")); });
  write_list(folder / "owner", "labelList", mesh.owner.size(), [&](std::size_t k) { return mesh.owner[k]; });
  write_list(folder / "neighbour", "labelList", mesh.neighbour.size(),
             [&](std::size_t k) { return mesh.neighbour[k]; });
  write_list(folder / "boundary", "polyBoundaryMesh", mesh.patches.size(), [&](std::size_t k) {
    const MeshPatch& patch = mesh.patches[k];
    return fmt::format("{} {{ type patch; nFaces {}; startFace {}; }}", patch.name, patch.faces, patch.first);
  });
}

double non_orthogonality(const FoamMesh& mesh) {
  double smallest = 1;
  for (std::size_t face = 0; face < mesh.neighbour.size(); ++face) {
    const pfv::Vec3 across = mesh.cell_centres[mesh.neighbour[face]] - mesh.cell_centres[mesh.owner[face]];
    smallest = std::min(smallest, across.normalized().dot(mesh.area(face).normalized()));
  }
  return std::acos(smallest) * 180 / std::numbers::pi;
}

} // namespace reference::openfoam
