#include "reference/openfoam/flow_fields.hpp"

#include "reference/openfoam/foam_reader.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace reference::openfoam {

namespace {

// The values that a field has on every patch, by face of the mesh. Patches come in the order of the mesh.
std::vector<double> read_patches(const std::filesystem::path& file, const FoamMesh& mesh) {
  FoamReader in(file);
  in.skip_past("boundaryField");
  std::vector<double> values(mesh.faces.size(), 0);
  for (const MeshPatch& patch : mesh.patches) {
    in.skip_past("\n    " + patch.name + "\n");
    in.skip_past("\n        value ");
    std::ranges::copy(in.scalar_field(patch.faces), values.begin() + static_cast<std::ptrdiff_t>(patch.first));
  }
  return values;
}

std::array<double, 6> sum_by_face(const std::vector<double>& flux, const FoamMesh& mesh) {
  std::array<double, 6> sums{};
  for (const MeshPatch& patch : mesh.patches)
    if (const auto* face = std::get_if<pfv::Face>(&patch.part)) {
      const auto first = flux.begin() + static_cast<std::ptrdiff_t>(patch.first);
      sums[static_cast<std::size_t>(pfv::index(*face))] =
          std::accumulate(first, first + static_cast<std::ptrdiff_t>(patch.faces), 0.0);
    }
  return sums;
}

} // namespace

FlowFields read_fields(const std::filesystem::path& folder, int iteration, const FoamMesh& mesh) {
  const auto written = folder / std::to_string(iteration);
  FlowFields fields;
  fields.face_pressure = read_patches(written / "p", mesh);
  FoamReader velocity(written / "U");
  velocity.skip_past("internalField");
  fields.velocity = velocity.vector_field(mesh.cells());
  fields.face_flux = sum_by_face(read_patches(written / "phi", mesh), mesh);
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
