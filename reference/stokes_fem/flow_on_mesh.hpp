#pragma once

#include "pfv/clock.hpp"
#include "pfv/problem/case.hpp"
#include "reference/answer.hpp"
#include "reference/probes.hpp"
#include "reference/stokes_fem/stokes_solver.hpp"

#include <filesystem>

namespace reference::stokes_fem {

/// Everything the finite elements say about a case of slip walls, pressure and periodic faces on a mesh of its void:
/// MSH 2.2, surface groups named as meshing::void_mesh names them; `bridge_radius` as in meshing::MeshSettings. Times
/// "assemble", "factor", "solve", "forces" and, when there are probes, "sample". Throws pfv::SolveError when the mesh
/// is not one of this case or the solver does not reach its tolerance.
Answer flow_on_mesh(const pfv::Case& problem, const std::filesystem::path& mesh, double bridge_radius,
                    pfv::Clock& clock, const Probes& probes = {}, const SolverSettings& settings = {});

} // namespace reference::stokes_fem
