#include "pfv/problem/read_parts.hpp"

#include "pfv/problem/read_generator.hpp"
#include "pfv/problem/toml_input.hpp"
#include "pfv/problem/validate.hpp"

#include <fmt/format.h>

namespace pfv {
namespace {

int line_of(const toml::node& node) {
  return static_cast<int>(node.source().begin.line);
}

std::string place_of(const toml::table& table, const toml::node& node) {
  return fmt::format("{}:{}", *table.source().path, line_of(node));
}

Box as_box(const toml::node& node) {
  const auto* corners = node.as_array();
  if (!corners || corners->size() != 2)
    fail_at(node, fmt::format("box \"{}\" must be two corners [[x, y, z], [x, y, z]] (m)", quote(node)));
  return {as_vector((*corners)[0], "box corner"), as_vector((*corners)[1], "box corner")};
}

Packing read_inline(const toml::table& table, const PeriodicAxes& periodic) {
  allow_keys(table, "[packing] with spheres", {"box", "spheres"});
  const toml::node& box = required(table, "[packing]", "box");
  Packing packing{as_box(box), {}};
  const toml::node& list = required(table, "[packing]", "spheres");
  const auto* rows = list.as_array();
  if (!rows)
    fail_at(list, fmt::format("spheres \"{}\" must be a list of [x, y, z, r] (m)", quote(list)));

  PackingOrigin origin{*table.source().path, place_of(table, box), {}};
  for (const toml::node& row : *rows) {
    const auto* values = row.as_array();
    if (!values || values->size() != 4)
      fail_at(row, fmt::format("sphere \"{}\" must be four numbers [x, y, z, r] (m)", quote(row)));
    const auto value = [&](int i) { return as_number((*values)[i], "sphere"); };
    packing.spheres.push_back({Vec3(value(0), value(1), value(2)), value(3)});
    origin.sphere_lines.push_back(line_of(row));
  }
  validate(packing, origin, periodic);
  return packing;
}

/// What [packing] says of its file, where `said` does not.
PackingFileOptions file_options(const toml::table& table, PackingFileOptions said) {
  if (const toml::node* scale = table.get("scale"); scale && !said.scale) {
    said.scale = as_number(*scale, "scale");
    located(*scale, [&] { validate_scale(*said.scale); });
  }
  if (const toml::node* box = table.get("box"); box && !said.box) {
    said.box = as_box(*box);
    said.box_place = place_of(table, *box);
  }
  return said;
}

} // namespace

ReadPacking read_packing(const toml::table& table, const std::filesystem::path& folder, const PeriodicAxes& periodic,
                         const PackingFileOptions& said) {
  const bool file = table.contains("file");
  const bool generator = table.contains("generator");
  const bool spheres = (table.contains("box") && !file) || (table.contains("spheres") && !generator);
  if (file + generator + spheres != 1)
    fail_at(table, "[packing] must have exactly one of file, generator, or box with spheres");
  if (!file && (said.scale || said.box))
    fail_at(table, fmt::format("{} is for a packing file; [packing] has none", said.scale ? "--scale" : "--box"));
  if (generator)
    return {read_generator(table, periodic), {}};
  if (spheres)
    return {read_inline(table, periodic), {}};
  allow_keys(table, "[packing] with a file", {"file", "scale", "box"});
  return read_packing_file(folder / as_text(*table.get("file"), "file"), file_options(table, said), periodic);
}

Fluid read_fluid(const toml::table& root) {
  const toml::node* node = root.get("fluid");
  if (!node)
    return {};
  const toml::table& table = as_table(*node, "fluid");
  allow_keys(table, "[fluid]", {"viscosity"});
  const toml::node* viscosity = table.get("viscosity");
  if (!viscosity)
    return {};
  const Fluid fluid{as_number(*viscosity, "viscosity")};
  located(*viscosity, [&] { validate(fluid); });
  return fluid;
}

std::optional<Buoyancy> read_buoyancy(const toml::table& root) {
  const toml::node* node = root.get("buoyancy");
  if (!node)
    return std::nullopt;
  const toml::table& table = as_table(*node, "buoyancy");
  allow_keys(table, "[buoyancy]", {"fluid_density", "gravity"});
  const Buoyancy buoyancy{as_number(required(table, "[buoyancy]", "fluid_density"), "fluid_density"),
                          as_vector(required(table, "[buoyancy]", "gravity"), "gravity")};
  located(table, [&] { validate(buoyancy); });
  return buoyancy;
}

} // namespace pfv
