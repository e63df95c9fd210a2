#include "pfv/simulation/read_scene.hpp"

#include "pfv/flow/choice.hpp"
#include "pfv/problem/read_parts.hpp"
#include "pfv/problem/toml_input.hpp"
#include "pfv/simulation/read_fluid_scene.hpp"
#include "pfv/simulation/read_grains.hpp"

#include <fmt/format.h>

namespace pfv {
namespace {

template <std::size_t... i>
void allow_tables(const toml::table& root, std::index_sequence<i...>) {
  allow_keys(root, "a scene",
             {"name", "packing", "grains", "contact", "walls", "local_damping", "cohesion",
              std::variant_alternative_t<i, BodyForce>::name..., "lubrication", "growth", "fluid", "flow", "faces",
              "pressure_points", "compressible_fluid", "pfv", "run"});
}

Duration read_run(const toml::table& table, Scene& scene) {
  allow_keys(table, "[run]", {"until", "steps", "unbalanced", "step", "scheme"});
  Duration duration;
  if (table.contains("until"))
    duration.until = positive(table, "until", 0);
  if (const toml::node* node = table.get("steps")) {
    const auto steps = as_integer(*node, "steps");
    if (steps < 1)
      fail_at(*node, fmt::format("steps \"{}\" must be a whole number, 1 or more", steps));
    duration.steps = static_cast<std::size_t>(steps);
  }
  if (const toml::node* node = table.get("unbalanced")) {
    duration.unbalanced = positive(table, "unbalanced", 0);
    if (scene.fluid)
      fail_at(*node,
              fmt::format("unbalanced \"{}\" is for dry grains: a fluid carries part of the load", quote(*node)));
    if (!duration.until && !duration.steps)
      fail_at(*node, fmt::format("unbalanced \"{}\" needs steps or until: the most it may take", quote(*node)));
  }
  if (table.contains("step"))
    scene.step = positive(table, "step", 0);
  if (const toml::node* node = table.get("scheme")) {
    const std::string name = as_text(*node, "scheme");
    located(*node, [&] { scene.scheme = choice_named<TimeScheme>("scheme", name); });
  }
  return duration;
}

} // namespace

SceneFile read_scene(const std::filesystem::path& file) {
  const toml::table root = read_toml(file);
  allow_tables(root, std::make_index_sequence<std::variant_size_v<BodyForce>>());
  SceneFile read;
  Scene& scene = read.scene;
  scene.name = file.stem().string();
  if (const toml::node* name = root.get("name"))
    scene.name = as_text(*name, "name");
  const auto* walls = part(root, "walls");
  const PeriodicAxes periodic = walls ? periodic_of(*walls) : PeriodicAxes{};
  ReadPacking packing =
      read_packing(as_table(required(root, "the scene", "packing"), "packing"), file.parent_path(), periodic);
  scene.packing = std::move(packing.packing);
  scene.notes = std::move(packing.notes);
  scene.grains = read_grains(root, scene.packing);
  scene.fluid = read_fluid_scene(file, root, scene.packing, periodic);
  if (const auto* table = part(root, "growth"))
    located(*table, [&] { require_growth_alone(scene); });
  if (const auto* table = part(root, "run"))
    read.duration = read_run(*table, scene);
  return read;
}

} // namespace pfv
