#include "pfv/simulation/read_scene.hpp"

#include "pfv/flow/choice.hpp"
#include "pfv/problem/read_conditions.hpp"
#include "pfv/problem/read_parts.hpp"
#include "pfv/problem/text.hpp"
#include "pfv/problem/toml_input.hpp"
#include "pfv/problem/validate.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <limits>

namespace pfv {
namespace {

constexpr double unbounded = std::numeric_limits<double>::infinity();

/// The number of a key, or what it is when left out; it must lie in [least, most], and not be zero when `positive`.
double number(const toml::table& table, std::string_view key, double otherwise, double least, double most = unbounded,
              bool positive = false) {
  const toml::node* node = table.get(key);
  if (!node)
    return otherwise;
  const double value = as_number(*node, key);
  if (!(std::isfinite(value) && value >= least && value <= most && (value > 0 || !positive)))
    fail_at(*node, fmt::format("{} \"{}\" must be {}{}", key, shortest(value),
                               positive ? "above 0" : fmt::format("at least {}", shortest(least)),
                               most < unbounded ? fmt::format(" and at most {}", shortest(most)) : ""));
  return value;
}

double positive(const toml::table& table, std::string_view key, double otherwise, double most = unbounded) {
  return number(table, key, otherwise, 0, most, true);
}

const toml::table* part(const toml::table& root, std::string_view name) {
  const toml::node* node = root.get(name);
  return node ? &as_table(*node, name) : nullptr;
}

ContactLaw read_contact(const toml::table& table) {
  const toml::node* law_node = table.get("law");
  const std::string name = law_node ? as_text(*law_node, "law") : std::string(LinearSprings::name);
  ContactLaw law;
  if (law_node)
    located(*law_node, [&] { law = choice_named<ContactLaw>("law", name); });
  const auto place = fmt::format("[contact] with law {}", name);
  Friction friction{number(table, "friction", 0.5, 0), number(table, "damping", 0, 0, 1)};
  if (auto* linear = std::get_if<LinearSprings>(&law)) {
    allow_keys(table, place, {"law", "young", "tangential_ratio", "friction", "damping"});
    linear->young = positive(table, "young", linear->young);
    linear->tangential_ratio = number(table, "tangential_ratio", linear->tangential_ratio, 0);
    linear->friction = friction;
  } else if (auto* constant = std::get_if<ConstantSprings>(&law)) {
    allow_keys(table, place, {"law", "normal", "tangential", "friction", "damping"});
    constant->normal = positive(table, "normal", constant->normal);
    constant->tangential = number(table, "tangential", constant->tangential, 0);
    constant->friction = friction;
  } else if (auto* hertz = std::get_if<HertzMindlin>(&law)) {
    allow_keys(table, place, {"law", "young", "poisson", "friction", "damping"});
    hertz->young = positive(table, "young", hertz->young);
    hertz->poisson = number(table, "poisson", hertz->poisson, 0, 0.5);
    hertz->friction = friction;
  }
  return law;
}

WallMotion read_wall(const toml::node& node, std::string_view name, double mass_of_grains) {
  if (node.is_string() && as_text(node, name) == "fixed")
    return FixedWall{};
  const auto* table = node.as_table();
  if (table && table->contains("velocity")) {
    allow_keys(*table, name, {"velocity"});
    return MovingWall{number(*table, "velocity", 0, -unbounded)};
  }
  if (table && table->contains("stress")) {
    allow_keys(*table, name, {"stress", "mass"});
    return LoadedWall{number(*table, "stress", 0, 0), positive(*table, "mass", mass_of_grains)};
  }
  fail_at(node, fmt::format("{} \"{}\" must be \"fixed\", {{ velocity = m/s }} or {{ stress = Pa, mass = kg }}", name,
                            quote(node)));
}

PeriodicAxes periodic_of(const toml::table& walls) {
  const toml::node* node = walls.get("periodic");
  return node ? as_periodic_axes(*node) : PeriodicAxes{};
}

Walls read_walls(const toml::table& table, double mass_of_grains) {
  allow_keys(table, "[walls]", {"friction", "periodic", "x_min", "x_max", "y_min", "y_max", "z_min", "z_max"});
  Walls walls;
  walls.friction = number(table, "friction", 0, 0);
  walls.periodic = periodic_of(table);
  for (const Face face : all_faces)
    if (const toml::node* node = table.get(face_names[index(face)])) {
      if (walls.periodic[index(axis_of(face))])
        fail_at(*node, fmt::format("{} \"{}\" cannot be: along a periodic axis there are no walls",
                                   face_names[index(face)], quote(*node)));
      walls.motion[index(face)] = read_wall(*node, face_names[index(face)], mass_of_grains);
    }
  return walls;
}

FilmMotion read_film_motion(const toml::node& node) {
  const std::string name = as_text(node, "resists");
  const auto found = std::ranges::find(film_motion_names, name);
  if (found == film_motion_names.end())
    fail_at(node, fmt::format("resists \"{}\" is not one of {}", name, fmt::join(film_motion_names, ", ")));
  return all_film_motions[found - film_motion_names.begin()];
}

/// The films are of the scene's fluid, which may flow between the grains or, where no flow is asked for, only be there.
Lubrication read_lubrication(const toml::table& table, const toml::table& root) {
  allow_keys(table, "[lubrication]", {"roughness", "reach", "resists"});
  const toml::table* fluid = part(root, "fluid");
  if (!fluid || !fluid->contains("viscosity"))
    fail_at(table, "[lubrication] needs the viscosity (Pa s) of [fluid]");
  Lubrication films{read_fluid(root).viscosity};
  films.reach = positive(table, "reach", films.reach, 1);
  films.roughness = positive(table, "roughness", films.roughness, 1);
  if (films.roughness >= films.reach)
    fail_at(table, fmt::format("roughness \"{}\" must be below reach \"{}\"", shortest(films.roughness),
                               shortest(films.reach)));
  if (const toml::node* node = table.get("resists")) {
    films.resists.clear();
    const toml::array* list = node->as_array();
    if (!list || list->empty())
      fail_at(*node, fmt::format("resists \"{}\" must be a list of some of {}", quote(*node),
                                 fmt::join(film_motion_names, ", ")));
    for (const toml::node& name : *list)
      films.resists.push_back(read_film_motion(name));
  }
  return films;
}

template <typename Force>
void read_body_force(const toml::table& root, std::vector<BodyForce>& forces) {
  const auto* table = part(root, Force::name);
  if (!table)
    return;
  const std::string place = fmt::format("[{}]", Force::name);
  Force read;
  std::vector<std::string_view> keys;
  for_each_key(read, [&](std::string_view key, auto&, std::string_view) { keys.push_back(key); });
  for (const auto& [key, node] : *table)
    if (std::ranges::find(keys, key.str()) == keys.end())
      fail_at(node, fmt::format("unknown key \"{}\" in {}; valid keys: {}", key.str(), place, fmt::join(keys, ", ")));
  for_each_key(read, [&](std::string_view key, auto& value, std::string_view) {
    const toml::node& node = required(*table, place, key);
    if constexpr (std::is_same_v<std::remove_reference_t<decltype(value)>, Vec3>)
      value = as_vector(node, key);
    else
      value = as_number(node, key);
  });
  if constexpr (requires { validate(read); })
    located(*table, [&] { validate(read); });
  forces.push_back(read);
}

/// One for each table that is there, in the order of the variant.
template <std::size_t... i>
std::vector<BodyForce> read_body_forces(const toml::table& root, std::index_sequence<i...>) {
  std::vector<BodyForce> forces;
  (read_body_force<std::variant_alternative_t<i, BodyForce>>(root, forces), ...);
  return forces;
}

template <std::size_t... i>
void allow_tables(const toml::table& root, std::index_sequence<i...>) {
  allow_keys(root, "a scene",
             {"name", "packing", "grains", "contact", "walls", "local_damping", "cohesion",
              std::variant_alternative_t<i, BodyForce>::name..., "lubrication", "growth", "fluid", "flow", "faces",
              "pressure_points", "compressible_fluid", "pfv", "run"});
}

constexpr std::make_index_sequence<std::variant_size_v<BodyForce>> each_body_force;

GrainScene read_grains(const toml::table& root, const Packing& packing) {
  GrainScene grains;
  if (const auto* table = part(root, "grains")) {
    allow_keys(*table, "[grains]", {"density"});
    grains.density = positive(*table, "density", grains.density);
  }
  if (const auto* table = part(root, "contact"))
    grains.law = read_contact(*table);
  double mass = 0;
  for (const Sphere& sphere : packing.spheres)
    mass += grains.density * volume(sphere);
  if (const auto* table = part(root, "walls"))
    grains.walls = read_walls(*table, mass);
  if (const auto* table = part(root, "local_damping")) {
    allow_keys(*table, "[local_damping]", {"share"});
    grains.damping.share = number(*table, "share", 0.2, 0, 0.99);
  }
  if (const auto* table = part(root, "cohesion")) {
    allow_keys(*table, "[cohesion]", {"tensile_strength", "shear_strength"});
    required(*table, "[cohesion]", "tensile_strength");
    required(*table, "[cohesion]", "shear_strength");
    grains.cohesion = Cohesion{number(*table, "tensile_strength", 0, 0), number(*table, "shear_strength", 0, 0)};
  }
  grains.forces = read_body_forces(root, each_body_force);
  if (const auto* table = part(root, "lubrication"))
    grains.lubrication = read_lubrication(*table, root);
  if (const auto* table = part(root, "growth")) {
    allow_keys(*table, "[growth]", {"rate", "stress"});
    required(*table, "[growth]", "rate");
    required(*table, "[growth]", "stress");
    grains.growth = Growth{positive(*table, "rate", 0), positive(*table, "stress", 0)};
  }
  return grains;
}

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
  allow_tables(root, each_body_force);
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
