#pragma once

#include "pfv/clock.hpp"
#include "pfv/problem/case.hpp"
#include "reference/answer.hpp"
#include "reference/probes.hpp"
#include "reference/stokes_fem/stokes_solver.hpp"

#include <filesystem>
#include <variant>

namespace reference::stokes_fem {

/// That the flow is to be found by solve_on_ranks(), also if on one.
struct SharedSolve {
  int ranks;
  double wall_limit; // s
};

/// In this process or by others.
using Solve = std::variant<SolverSettings, SharedSolve>;

/// Everything the finite elements say about a case of slip walls, pressure and periodic faces on a mesh of its void:
/// MSH 2.2, surface groups named as meshing::void_mesh names them; `bridge_radius` as in meshing::MeshSettings. Times
/// "assemble", "factor", "solve", "forces" and, when there are probes, "sample". Throws pfv::SolveError when the mesh
/// is not one of this case or the solver does not reach its tolerance.
Answer flow_on_mesh(const pfv::Case& problem, const std::filesystem::path& mesh, double bridge_radius,
                    pfv::Clock& clock, const Probes& probes = {}, const Solve& solve = SolverSettings{});

} // namespace reference::stokes_fem
