#include "reference/openfoam/foam_mesh.hpp"

#include "pfv/problem/error.hpp"
#include "reference/openfoam/foam_reader.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
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

std::vector<std::array<std::size_t, 3>> read_faces(const std::filesystem::path& file) {
  FoamReader in(file);
  in.skip_header();
  std::vector<std::array<std::size_t, 3>> faces(in.count());
  in.expect('(');
  for (auto& face : faces) {
    in.expect('3');
    in.expect('(');
    for (std::size_t& point : face)
      point = in.count();
    in.expect(')');
  }
  return faces;
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

pfv::Vec3 FoamMesh::centre(std::size_t face) const {
  const auto& [a, b, c] = faces[face];
  return (points[a] + points[b] + points[c]) / 3;
}

pfv::Vec3 FoamMesh::area(std::size_t face) const {
  const auto& [a, b, c] = faces[face];
  return 0.5 * (points[b] - points[a]).cross(points[c] - points[a]);
}

// Each corner of a tetrahedron belongs to three of its four faces.
std::vector<pfv::Vec3> tetrahedron_centres(const FoamMesh& mesh) {
  // The cell numbered last may own no face at all.
  const std::size_t last = std::max(std::ranges::max(mesh.owner), std::ranges::max(mesh.neighbour));
  std::vector<pfv::Vec3> centres(last + 1, pfv::Vec3::Zero());
  for (std::size_t face = 0; face < mesh.faces.size(); ++face) {
    const pfv::Vec3 part = mesh.centre(face) / 4;
    centres[mesh.owner[face]] += part;
    if (face < mesh.neighbour.size())
      centres[mesh.neighbour[face]] += part;
  }
  return centres;
}

double volume(const FoamMesh& mesh) {
  double sum = 0;
  for (std::size_t face = mesh.neighbour.size(); face < mesh.faces.size(); ++face)
    sum += mesh.centre(face).dot(mesh.area(face)) / 3;
  return sum;
}

FoamMesh read_mesh(const std::filesystem::path& case_folder) {
  const auto folder = case_folder / "constant" / "polyMesh";
  FoamMesh mesh;
  mesh.points = read_points(folder / "points");
  mesh.faces = read_faces(folder / "faces");
  mesh.owner = read_cells(folder / "owner");
  mesh.neighbour = read_cells(folder / "neighbour");
  mesh.patches = read_patches(folder / "boundary");
  if (mesh.owner.size() != mesh.faces.size() || mesh.neighbour.empty())
    throw pfv::SolveError("OpenFOAM's mesh has no interior or an owner list of the wrong length");
  mesh.cell_centres = tetrahedron_centres(mesh);
  return mesh;
}

void write_points(const std::filesystem::path& case_folder, const FoamMesh& mesh) {
  const auto file = case_folder / "constant" / "polyMesh" / "points";
  std::ofstream out(file);
  out << "FoamFile { version 2.0; format ascii; class vectorField; object points; }\n// * * //\n"
      << mesh.points.size() << "\n(\n";
  for (const pfv::Vec3& point : mesh.points)
    out << fmt::format("({} {} {})\n", point.x(), point.y(), point.z());
  out << ")\n";
  if (!out.flush())
    throw pfv::SolveError("cannot write " + file.string());
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
