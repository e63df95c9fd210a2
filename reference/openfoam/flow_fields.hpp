#pragma once

#include "pfv/problem/face.hpp"
#include "reference/openfoam/foam_mesh.hpp"

#include <array>
#include <filesystem>
#include <vector>

namespace reference::openfoam {

/// What simpleFoam wrote last, in the units it was solved in.
struct FlowFields {
  std::vector<double> pressure;      // by cell
  std::vector<pfv::Vec3> velocity;   // by cell
  std::array<double, 6> face_flux{}; // by pfv::Face, out of the box
};

/// Throws pfv::SolveError when a file is missing or not of this mesh.
FlowFields read_fields(const std::filesystem::path& folder, int iteration, const FoamMesh& mesh);

/// Net flux over half the gross flux of all faces: |Qin / Qout - 1| when one goes in and one out.
double flux_imbalance(const std::array<double, 6>& face_flux);

} // namespace reference::openfoam
