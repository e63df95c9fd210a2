#include "pfv/simulation/read_grains.hpp"

#include "pfv/flow/choice.hpp"
#include "pfv/problem/read_conditions.hpp"
#include "pfv/problem/read_parts.hpp"
#include "pfv/problem/text.hpp"
#include "pfv/problem/toml_input.hpp"
#include "pfv/problem/validate.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace pfv {
namespace {

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

constexpr std::make_index_sequence<std::variant_size_v<BodyForce>> each_body_force;

} // namespace

PeriodicAxes periodic_of(const toml::table& walls) {
  const toml::node* node = walls.get("periodic");
  return node ? as_periodic_axes(*node) : PeriodicAxes{};
}

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

} // namespace pfv
