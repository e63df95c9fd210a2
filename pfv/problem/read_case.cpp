#include "pfv/problem/case.hpp"

#include "pfv/problem/read_generator.hpp"
#include "pfv/problem/toml_input.hpp"
#include "pfv/problem/validate.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace pfv {

namespace {

int line_of(const toml::node& node) {
  return static_cast<int>(node.source().begin.line);
}

Packing read_inline(const toml::table& table) {
  allow_keys(table, "[packing] with spheres", {"box", "spheres"});
  const toml::node& box = required(table, "[packing]", "box");
  const auto* corners = box.as_array();
  if (!corners || corners->size() != 2)
    fail_at(box, fmt::format("box \"{}\" must be two corners [[x, y, z], [x, y, z]] (m)", quote(box)));
  const toml::node& list = required(table, "[packing]", "spheres");
  const auto* rows = list.as_array();
  if (!rows)
    fail_at(list, fmt::format("spheres \"{}\" must be a list of [x, y, z, r] (m)", quote(list)));

  Packing packing{{as_vector((*corners)[0], "box corner"), as_vector((*corners)[1], "box corner")}, {}};
  PackingOrigin origin{*table.source().path, line_of(box), {}};
  for (const toml::node& row : *rows) {
    const auto* values = row.as_array();
    if (!values || values->size() != 4)
      fail_at(row, fmt::format("sphere \"{}\" must be four numbers [x, y, z, r] (m)", quote(row)));
    const auto value = [&](int i) { return as_number((*values)[i], "sphere"); };
    packing.spheres.push_back({Vec3(value(0), value(1), value(2)), value(3)});
    origin.sphere_lines.push_back(line_of(row));
  }
  validate(packing, origin);
  return packing;
}

Packing read_packing(const toml::table& table, const std::filesystem::path& folder) {
  const bool file = table.contains("file");
  const bool generator = table.contains("generator");
  const bool spheres = table.contains("box") || (table.contains("spheres") && !generator);
  if (file + generator + spheres != 1)
    fail_at(table, "[packing] must have exactly one of file, generator, or box with spheres");
  if (generator)
    return read_generator(table);
  if (spheres)
    return read_inline(table);
  allow_keys(table, "[packing] with a file", {"file"});
  return pfv::read_packing(folder / as_text(*table.get("file"), "file"));
}

Fluid read_fluid(const toml::table& table) {
  allow_keys(table, "[fluid]", {"viscosity"});
  const toml::node* viscosity = table.get("viscosity");
  if (!viscosity)
    return {};
  const Fluid fluid{as_number(*viscosity, "viscosity")};
  located(*viscosity, [&] { validate(fluid); });
  return fluid;
}

FaceConditions read_flow(const toml::table& table) {
  allow_keys(table, "[flow]", {"axis", "pressure_drop"});
  const toml::node& axis = required(table, "[flow]", "axis");
  const auto name = std::ranges::find(axis_names, as_text(axis, "axis"));
  if (name == axis_names.end())
    fail_at(axis, fmt::format("axis \"{}\" must be one of {}", quote(axis), fmt::join(axis_names, ", ")));
  double drop = 1;
  if (const toml::node* node = table.get("pressure_drop")) {
    drop = as_number(*node, "pressure_drop");
    if (!std::isfinite(drop) || drop == 0)
      fail_at(*node, fmt::format("pressure_drop \"{}\" must be a finite number other than zero (Pa)", quote(*node)));
  }
  return flow_along(static_cast<Axis>(name - axis_names.begin()), drop);
}

FaceCondition read_face(const toml::node& node, std::string_view name) {
  if (const auto* text = node.as_string(); text && text->get() == "slip")
    return SlipWall{};
  const auto* table = node.as_table();
  if (!table)
    fail_at(node, fmt::format("{} \"{}\" must be \"slip\" or {{ pressure = <Pa> }}", name, quote(node)));
  allow_keys(*table, name, {"pressure"});
  return Pressure{as_number(required(*table, name, "pressure"), "pressure")};
}

FaceConditions read_faces(const toml::table& table) {
  allow_keys(table, "[faces]", {"x_min", "x_max", "y_min", "y_max", "z_min", "z_max"});
  FaceConditions faces{};
  for (const Face face : all_faces)
    if (const toml::node* node = table.get(face_names[index(face)]))
      faces[index(face)] = read_face(*node, face_names[index(face)]);
  located(table, [&] { validate(faces); });
  return faces;
}

Buoyancy read_buoyancy(const toml::table& table) {
  allow_keys(table, "[buoyancy]", {"fluid_density", "gravity"});
  const Buoyancy buoyancy{as_number(required(table, "[buoyancy]", "fluid_density"), "fluid_density"),
                          as_vector(required(table, "[buoyancy]", "gravity"), "gravity")};
  located(table, [&] { validate(buoyancy); });
  return buoyancy;
}

} // namespace

Case read_case(const std::filesystem::path& file) {
  const toml::table root = read_toml(file);
  allow_keys(root, "a case", {"name", "packing", "fluid", "flow", "faces", "buoyancy"});
  Case problem;
  problem.name = file.stem().string();
  if (const toml::node* name = root.get("name"))
    problem.name = as_text(*name, "name");
  problem.packing = read_packing(as_table(required(root, "the case", "packing"), "packing"), file.parent_path());
  if (const toml::node* fluid = root.get("fluid"))
    problem.fluid = read_fluid(as_table(*fluid, "fluid"));
  const toml::node* flow = root.get("flow");
  const toml::node* faces = root.get("faces");
  if ((flow == nullptr) == (faces == nullptr))
    fail_at(flow ? *faces : root, "a case must have exactly one of [flow] and [faces]");
  problem.faces = flow ? read_flow(as_table(*flow, "flow")) : read_faces(as_table(*faces, "faces"));
  if (const toml::node* buoyancy = root.get("buoyancy"))
    problem.buoyancy = read_buoyancy(as_table(*buoyancy, "buoyancy"));
  return problem;
}

} // namespace pfv
