#include "reference/stokes_fem/stokes_fem.hpp"

#include "meshing/void_mesh.hpp"
#include "reference/stokes_fem/flow_on_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace reference {

namespace {

std::string text(double value) {
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%.4g", value);
  return buffer;
}

class StokesFem final : public Method {
public:
  std::string name() const override { return "stokes_fem"; }

  std::string description() const override { return "Stokes flow by finite elements of order 2/1 (deal.II)"; }

  std::optional<std::string> not_covered(const pfv::Case& problem) const override {
    const bool driven = std::ranges::any_of(
        problem.faces, [](const auto& face) { return std::holds_alternative<pfv::Pressure>(face); });
    if (!driven)
      return "no face has a pressure, so the pressure is not unique";
    return std::nullopt;
  }

  std::optional<double> convergence_order() const override { return 2; }

  Estimate estimate(const pfv::Case& problem, const Resolution& resolution) const override {
    const double spheres = static_cast<double>(problem.packing.spheres.size());
    const double unknowns = 1.6e4 * spheres / std::pow(resolution.mesh_size, 3);
    return {unknowns, 3e-5 * unknowns, 2e3 * unknowns};
  }

  Answer solve(const pfv::Case& problem, const Resolution& resolution, pfv::Clock& clock) const override {
    const meshing::MeshSettings settings{.mesh_size = resolution.mesh_size};
    const meshing::VoidMesh mesh = meshing::void_mesh(problem, settings, meshing::default_mesh_cache());
    pfv::Clock own;
    own.add("mesh", mesh.cpu_seconds);
    Answer answer = stokes_fem::flow_on_mesh(problem, mesh.file, settings.bridge_radius, own);
    for (const pfv::Stage& stage : own.stages())
      clock.add(stage.name, stage.cpu_seconds);
    answer.method = name();
    answer.mesh_size = resolution.mesh_size;
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
