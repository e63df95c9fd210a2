#include "reference/stokes_fem/stokes_fem.hpp"

#include "meshing/void_mesh.hpp"
#include "pfv/problem/error.hpp"
#include "reference/cut_spheres.hpp"
#include "reference/stokes_fem/discretise.hpp"
#include "reference/stokes_fem/estimate_cost.hpp"
#include "reference/stokes_fem/flow_on_mesh.hpp"
#include "reference/walls_and_pressures.hpp"

#include <algorithm>
#include <cstdio>

namespace reference {

namespace {

// The mesher's lengths are its own; these keep the permeability of lattices, touching or not, within 1 % of the exact
// one (measured: 0.5 to 0.8 %; at 1 still 0.7 to 1.2 %).
constexpr double mesher_size = 0.85;

meshing::MeshSettings mesh_settings(const Request& request) {
  return {.mesh_size = mesher_size * request.mesh_size};
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

  std::optional<std::string> unavailable() const override { return meshing::mesher_unavailable(); }

  std::optional<std::string> not_covered(const pfv::Case& problem) const override {
    if (const auto what = beyond_walls_and_pressures(problem))
      return what;
    const bool driven = std::ranges::any_of(
        problem.faces, [](const auto& face) { return std::holds_alternative<pfv::Pressure>(face); });
    if (!driven)
      return "no face has a pressure, so the pressure is not unique";
    return std::nullopt;
  }

  // Measured on simple cubic (solid fraction 0.343 and touching), bcc (0.45 and touching) and touching fcc between
  // mesher sizes 1 and 0.7: 2.5 to 3.2 once the bridges' own 0.2 % is taken off. The low end, as from meshes coarser
  // than that the order is lower still.
  std::optional<double> convergence_order() const override { return 2.5; }

  Estimate estimate(const pfv::Case& problem, const Request& request) const override {
    return stokes_fem::estimate_cost(problem.packing, mesh_settings(request).mesh_size);
  }

  Answer solve(const pfv::Case& problem, const Request& request, pfv::Clock& clock) const override {
    if (const auto reason = not_covered(problem))
      throw pfv::SolveError("stokes_fem does not cover this case: " + *reason);
    const meshing::MeshSettings settings = mesh_settings(request);
    const meshing::VoidMesh mesh = meshing::void_mesh(problem, settings, meshing::default_mesh_cache());
    pfv::Clock own;
    own.add("mesh", mesh.cpu_seconds);
    Answer answer = stokes_fem::flow_on_mesh(problem, mesh.file, settings.bridge_radius, own);
    add_pressure_on_discs(problem, *answer.sphere_forces, *answer.wall_forces);
    give_normal_parts_to_slip_walls(problem, *answer.sphere_forces, *answer.wall_forces);
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
