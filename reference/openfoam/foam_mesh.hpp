#pragma once

#include "pfv/problem/vec3.hpp"
#include "reference/openfoam/patches.hpp"

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace reference::openfoam {

struct MeshPatch {
  std::string name;
  Patch part;
  std::size_t first; // of its faces
  std::size_t faces;
};

/// A mesh of polyhedra as OpenFOAM numbers it: faces of the interior first, then patch by patch.
struct FoamMesh {
  std::vector<pfv::Vec3> points;
  std::vector<std::size_t> corners;         // points of all faces, one face after the other
  std::vector<std::size_t> first_corner{0}; // by face, and the end of the last
  std::vector<std::size_t> owner;           // cell by face; the face's normal points out of it
  std::vector<std::size_t> neighbour;       // cell on the other side, of the interior faces only
  std::vector<MeshPatch> patches;
  std::vector<pfv::Vec3> cell_centres;

  std::size_t cells() const { return cell_centres.size(); }
  std::size_t faces() const { return first_corner.size() - 1; }
  std::span<const std::size_t> face(std::size_t face) const {
    return std::span(corners).subspan(first_corner[face], first_corner[face + 1] - first_corner[face]);
  }
  void add_face(std::span<const std::size_t> points_of_face);

  pfv::Vec3 middle(std::size_t face) const; // mean of the corners
  pfv::Vec3 centre(std::size_t face) const; // of the triangles between the sides and the middle, as OpenFOAM sees it
  pfv::Vec3 area(std::size_t face) const;   // normal times area
};

/// Centroids, from the pyramids between the faces and the mean of their centres.
std::vector<pfv::Vec3> cell_centres(const FoamMesh& mesh);

/// Volume inside the patches.
double volume(const FoamMesh& mesh);

/// Reads constant/polyMesh of a case folder. Throws pfv::SolveError when a file is not as expected.
FoamMesh read_mesh(const std::filesystem::path& case_folder);

/// Writes constant/polyMesh/points. Throws pfv::SolveError when it cannot.
void write_points(const std::filesystem::path& case_folder, const FoamMesh& mesh);

/// Writes constant/polyMesh, all patches as plain ones, without zones. Throws pfv::SolveError when it cannot.
void write_mesh(const std::filesystem::path& case_folder, const FoamMesh& mesh);

/// Largest angle in degrees between the line that joins two cell centres and the normal of the face between them.
double non_orthogonality(const FoamMesh& mesh);

} // namespace reference::openfoam
