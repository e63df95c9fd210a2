#include "pfv/simulation/read_fluid_scene.hpp"

#include "pfv/problem/read_conditions.hpp"
#include "pfv/problem/read_parts.hpp"
#include "pfv/problem/toml_input.hpp"
#include "pfv/problem/validate.hpp"

#include <fmt/format.h>

namespace pfv {
namespace {

/// The faces of the fluid, periodic where the grains have no walls.
FacesInTime read_fluid_faces(const toml::table* flow, const toml::table* faces, const Box& box,
                             const PeriodicAxes& periodic) {
  if (flow) {
    const FlowAlong along = read_flow(*flow);
    if (along.periodic != PeriodicAxes{} && along.periodic != periodic)
      fail_at(*flow->get("periodic"), "periodic of [flow] must be that of [walls], or left out");
    return {flow_along(along.axis, along.pressure_drop, periodic, box, along.tangential), {}};
  }
  FacesInTime read = read_faces_in_time(*faces);
  for (const Face face : all_faces) {
    const toml::node* node = faces->get(face_names[index(face)]);
    FaceCondition& condition = read.faces[index(face)];
    const bool repeats = periodic[index(axis_of(face))];
    if (node && std::holds_alternative<Periodic>(condition) != repeats)
      fail_at(*node, fmt::format("{} \"{}\" {}", face_names[index(face)], quote(*node),
                                 repeats ? "must be \"periodic\" or left out, as its axis is periodic in [walls]"
                                         : "needs periodic in [walls] to name its axis"));
    if (repeats && !node)
      condition = Periodic{};
  }
  return read;
}

} // namespace

std::optional<FluidScene> read_fluid_scene(const std::filesystem::path& file, const toml::table& root,
                                           const Packing& packing, const PeriodicAxes& periodic) {
  const auto *flow = part(root, "flow"), *faces = part(root, "faces");
  if (flow && faces)
    fail_at(*faces, "a scene has at most one of [flow] and [faces]");
  if (!flow && !faces) {
    for (const std::string_view key : {"fluid", "compressible_fluid", "pfv", "pressure_points"})
      if (const toml::node* node = root.get(key); node && !(key == "fluid" && root.contains("lubrication")))
        fail_at(*node, fmt::format("[{}] needs [flow] or [faces]: without them the scene is dry", key));
    return std::nullopt;
  }
  FluidScene fluid;
  fluid.fluid = read_fluid(root);
  FacesInTime read = read_fluid_faces(flow, faces, packing.box, periodic);
  fluid.faces = std::move(read.faces);
  fluid.in_time = std::move(read.pressures);
  if (const toml::node* points = root.get("pressure_points"))
    fluid.pressure_points = read_pressure_points(*points, packing.box);
  if (const auto* table = part(root, "pfv"))
    allow_keys(*table, "[pfv] of a scene", {"conductance", "walls"});
  fluid.options = read_flow_options(file, {});
  if (const auto* table = part(root, "compressible_fluid")) {
    allow_keys(*table, "[compressible_fluid]", {"bulk_modulus"});
    required(*table, "[compressible_fluid]", "bulk_modulus");
    fluid.compressible = CompressibleFluid{positive(*table, "bulk_modulus", 1)};
  }
  return fluid;
}

} // namespace pfv
