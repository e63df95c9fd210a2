#include "reference/stokes_fem/stokes_fem.hpp"

#include "meshing/void_mesh.hpp"
#include "pfv/problem/error.hpp"
#include "reference/cut_spheres.hpp"
#include "reference/stokes_fem/discretise.hpp"
#include "reference/stokes_fem/estimate_cost.hpp"
#include "reference/stokes_fem/flow_on_mesh.hpp"
#include "reference/stokes_fem/ranks_cost.hpp"
#include "reference/walls_and_pressures.hpp"

#include <algorithm>
#include <cstdio>

namespace reference {

namespace {

// The mesher's lengths are its own; these keep the permeability of lattices, touching or not, within 1 % of the exact
// one (measured: 0.2 to 0.4 %; at 1.4 times that size 0.7 to 1.1 %, at 0.7 times 0.07 to 0.15 %).
constexpr double mesher_size = 0.85;

meshing::MeshSettings mesh_settings(const Request& request) {
  return {.mesh_size = mesher_size * request.mesh_size};
}

/// The same with walls in place of periodic faces.
pfv::Case without_periodic(pfv::Case problem) {
  for (pfv::FaceCondition& face : problem.faces)
    if (std::holds_alternative<pfv::Periodic>(face))
      face = pfv::SlipWall{};
  return problem;
}

/// The same in a box that goes on where it repeats, so that no sphere is cut there.
pfv::Case beyond_periodic_faces(pfv::Case problem) {
  const pfv::PeriodicAxes periodic = periodic_axes(problem.faces);
  pfv::Box& box = problem.packing.box;
  const pfv::Vec3 size = box.size();
  for (int axis = 0; axis < 3; ++axis)
    if (periodic[static_cast<std::size_t>(axis)]) {
      box.lower[axis] -= size[axis];
      box.upper[axis] += size[axis];
    }
  return problem;
}

std::string text(double value) {
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%.4g", value);
  return buffer;
}

class StokesFem final : public Method {
public:
  std::string name() const override { return "stokes_fem"; }

  std::string description() const override { return "Stokes flow by finite elements of order 2/1 (deal.II)"; }

  std::string version() const override { return stokes_fem::element_library() + ", " + meshing::mesher_version(); }

  std::vector<std::string> built_from() const override {
    return {"pfv/problem", "pfv/solvers", "meshing", "reference/stokes_fem"};
  }

  std::optional<std::string> unavailable() const override { return meshing::mesher_unavailable(); }

  std::optional<std::string> not_covered(const pfv::Case& problem) const override {
    if (const auto what = beyond_walls_and_pressures(without_periodic(problem)))
      return what;
    const bool driven = std::ranges::any_of(
        problem.faces, [](const auto& face) { return std::holds_alternative<pfv::Pressure>(face); });
    if (!driven && imposed_gradient(problem.faces).isZero(0))
      return "no face has a pressure and no periodic axis a gradient, so nothing drives the flow";
    return std::nullopt;
  }

  // Measured on simple cubic, bcc and fcc lattices of solid fraction 0.125 to touching at mesh sizes 1.4, 1 and 0.7:
  // 3.1 to 4.5, where 4 is what quadratic elements on quadratic cells give a smooth flow.
  std::optional<double> convergence_order() const override { return 3.5; }

  bool runs_on_ranks() const override { return true; }

  Estimate estimate(const pfv::Case& problem, const Request& request) const override {
    const double mesh_size = mesh_settings(request).mesh_size;
    return request.ranks > 1 ? stokes_fem::estimate_cost_on_ranks(problem, mesh_size, request.ranks)
                             : stokes_fem::estimate_cost(problem, mesh_size);
  }

  Answer solve(const pfv::Case& problem, const Request& request, pfv::Clock& clock) const override {
    if (const auto reason = not_covered(problem))
      throw pfv::SolveError("stokes_fem does not cover this case: " + *reason);
    const meshing::MeshSettings settings = mesh_settings(request);
    const meshing::VoidMesh mesh = meshing::void_mesh(problem, settings, meshing::default_mesh_cache());
    pfv::Clock own;
    own.add("mesh", mesh.cpu_seconds);
    stokes_fem::Solve how;
    if (request.ranks > 1)
      how = stokes_fem::SharedSolve{request.ranks, 600 + 20 * estimate(problem, request).cpu_seconds};
    Answer answer = stokes_fem::flow_on_mesh(problem, mesh.file, settings.bridge_radius, own, request.probes, how);
    add_pressure_on_discs(beyond_periodic_faces(problem), *answer.sphere_forces, *answer.wall_forces);
    give_normal_parts_to_slip_walls(problem, *answer.sphere_forces, *answer.wall_forces);
    drop_normal_parts_at_slip_walls(problem, *answer.sphere_viscous_forces);
    for (const pfv::Stage& stage : own.stages())
      clock.add(stage.name, stage.cpu_seconds);
    answer.method = name();
    answer.mesh_size = request.mesh_size;
    answer.stages = own.stages();
    answer.counts["bridges"] = static_cast<double>(mesh.quality.bridges);
    answer.counts["volume_error"] = *answer.porosity * problem.packing.box.volume() / mesh.quality.exact_volume - 1;
    answer.counts["worst_quality"] = mesh.quality.worst_quality;
    answer.notes["mesh"] = "gmsh, linear tetrahedra bent by this method; volume error before bending " +
                           text(mesh.quality.volume_error) + ", surface error " + text(mesh.quality.surface_error);
    return answer;
  }
};

} // namespace

std::unique_ptr<Method> make_stokes_fem() {
  return std::make_unique<StokesFem>();
}

} // namespace reference
