#include "reference/openfoam/flow_fields.hpp"

#include "reference/openfoam/foam_reader.hpp"

#include <cmath>
#include <numeric>

namespace reference::openfoam {

namespace {

std::array<double, 6> read_face_flux(const std::filesystem::path& file, const FoamMesh& mesh) {
  std::array<double, 6> flux{};
  for (const MeshPatch& patch : mesh.patches)
    if (const auto* face = std::get_if<pfv::Face>(&patch.part)) {
      FoamReader in(file);
      in.skip_past("boundaryField");
      in.skip_past("\n    " + patch.name + "\n");
      in.skip_past("value");
      const auto values = in.scalar_field(patch.faces);
      flux[static_cast<std::size_t>(pfv::index(*face))] = std::accumulate(values.begin(), values.end(), 0.0);
    }
  return flux;
}

} // namespace

FlowFields read_fields(const std::filesystem::path& folder, int iteration, const FoamMesh& mesh) {
  const auto written = folder / std::to_string(iteration);
  FlowFields fields;
  FoamReader pressure(written / "p");
  pressure.skip_past("internalField");
  fields.pressure = pressure.scalar_field(mesh.cells());
  FoamReader velocity(written / "U");
  velocity.skip_past("internalField");
  fields.velocity = velocity.vector_field(mesh.cells());
  fields.face_flux = read_face_flux(written / "phi", mesh);
  return fields;
}

double flux_imbalance(const std::array<double, 6>& face_flux) {
  double net = 0, gross = 0;
  for (const double flux : face_flux) {
    net += flux;
    gross += std::abs(flux);
  }
  return std::abs(net) / (gross / 2);
}

} // namespace reference::openfoam
