#pragma once

#include "pfv/problem/vec3.hpp"
#include "reference/openfoam/patches.hpp"

#include <array>
#include <filesystem>
#include <string>
#include <vector>

namespace reference::openfoam {

struct MeshPatch {
  std::string name;
  Patch part;
  std::size_t first; // of its faces
  std::size_t faces;
};

/// A mesh of tetrahedra as OpenFOAM numbers it: faces of the interior first, then patch by patch.
struct FoamMesh {
  std::vector<pfv::Vec3> points;
  std::vector<std::array<std::size_t, 3>> faces;
  std::vector<std::size_t> owner;     // cell by face; the face's normal points out of it
  std::vector<std::size_t> neighbour; // cell on the other side, of the interior faces only
  std::vector<MeshPatch> patches;
  std::vector<pfv::Vec3> cell_centres;

  std::size_t cells() const { return cell_centres.size(); }
  pfv::Vec3 centre(std::size_t face) const;
  pfv::Vec3 area(std::size_t face) const; // normal times area
};

std::vector<pfv::Vec3> tetrahedron_centres(const FoamMesh& mesh);

/// Volume inside the patches.
double volume(const FoamMesh& mesh);

/// Reads constant/polyMesh of a case folder. Throws pfv::SolveError when a file is not as expected.
FoamMesh read_mesh(const std::filesystem::path& case_folder);

/// Writes constant/polyMesh/points. Throws pfv::SolveError when it cannot.
void write_points(const std::filesystem::path& case_folder, const FoamMesh& mesh);

/// Largest angle in degrees between the line that joins two cell centres and the normal of the face between them.
double non_orthogonality(const FoamMesh& mesh);

} // namespace reference::openfoam
