#include "pfv/problem/case.hpp"

#include "pfv/problem/read_conditions.hpp"
#include "pfv/problem/read_generator.hpp"
#include "pfv/problem/toml_input.hpp"
#include "pfv/problem/validate.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace pfv {

namespace {

int line_of(const toml::node& node) {
  return static_cast<int>(node.source().begin.line);
}

Packing read_inline(const toml::table& table, const PeriodicAxes& periodic) {
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
  validate(packing, origin, periodic);
  return packing;
}

Packing read_packing(const toml::table& table, const std::filesystem::path& folder, const PeriodicAxes& periodic) {
  const bool file = table.contains("file");
  const bool generator = table.contains("generator");
  const bool spheres = table.contains("box") || (table.contains("spheres") && !generator);
  if (file + generator + spheres != 1)
    fail_at(table, "[packing] must have exactly one of file, generator, or box with spheres");
  if (generator)
    return read_generator(table, periodic);
  if (spheres)
    return read_inline(table, periodic);
  allow_keys(table, "[packing] with a file", {"file"});
  return pfv::read_packing(folder / as_text(*table.get("file"), "file"), periodic);
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

Buoyancy read_buoyancy(const toml::table& table) {
  allow_keys(table, "[buoyancy]", {"fluid_density", "gravity"});
  const Buoyancy buoyancy{as_number(required(table, "[buoyancy]", "fluid_density"), "fluid_density"),
                          as_vector(required(table, "[buoyancy]", "gravity"), "gravity")};
  located(table, [&] { validate(buoyancy); });
  return buoyancy;
}

FaceInput read_face_input(const toml::table& root) {
  const toml::node* flow = root.get("flow");
  const toml::node* faces = root.get("faces");
  if ((flow == nullptr) == (faces == nullptr))
    fail_at(flow ? *faces : root, "a case must have exactly one of [flow] and [faces]");
  if (flow)
    return read_flow(as_table(*flow, "flow"));
  return read_faces(as_table(*faces, "faces"));
}

std::string names_of(const PeriodicAxes& periodic) {
  std::vector<std::string_view> names;
  for (const Axis axis : {Axis::x, Axis::y, Axis::z})
    if (periodic[index(axis)])
      names.push_back(axis_names[index(axis)]);
  return fmt::format("{}", fmt::join(names, ","));
}

/// What the command line says of the flow instead of the file.
FaceInput overridden(FaceInput input, const QuestionOptions& options) {
  if (options.axis) {
    if (!std::holds_alternative<FlowAlong>(input))
      input = FlowAlong{};
    std::get<FlowAlong>(input).axis = *options.axis;
  }
  if (options.periodic) {
    auto* flow = std::get_if<FlowAlong>(&input);
    if (!flow)
      throw InputError(
          fmt::format("--periodic \"{}\" needs --axis or a case with [flow]; [faces] says which are periodic",
                      names_of(*options.periodic)));
    flow->periodic = *options.periodic;
  }
  return input;
}

PeriodicAxes periodic_axes(const FaceInput& input) {
  const auto* flow = std::get_if<FlowAlong>(&input);
  return flow ? flow->periodic : pfv::periodic_axes(std::get<FaceConditions>(input));
}

FaceConditions face_conditions(const FaceInput& input, const Box& box) {
  const auto* flow = std::get_if<FlowAlong>(&input);
  return flow ? flow_along(flow->axis, flow->pressure_drop, flow->periodic, box, flow->tangential)
              : std::get<FaceConditions>(input);
}

Case read_case(const std::filesystem::path& file, const QuestionOptions& options) {
  const toml::table root = read_toml(file);
  allow_keys(root, "a case", {"name", "packing", "fluid", "flow", "faces", "pressure_points", "buoyancy", "pfv"});
  Case problem;
  problem.name = file.stem().string();
  if (const toml::node* name = root.get("name"))
    problem.name = as_text(*name, "name");
  const toml::table& packing = as_table(required(root, "the case", "packing"), "packing");
  const FaceInput input = overridden(read_face_input(root), options);
  problem.packing = read_packing(packing, file.parent_path(), periodic_axes(input));
  problem.faces = face_conditions(input, problem.packing.box);
  if (const toml::node* fluid = root.get("fluid"))
    problem.fluid = read_fluid(as_table(*fluid, "fluid"));
  if (const toml::node* points = root.get("pressure_points"))
    problem.pressure_points = read_pressure_points(*points, problem.packing.box);
  const toml::node* faces = root.get("faces");
  located(faces ? *faces : root, [&] { validate_level(problem.faces, problem.pressure_points); });
  if (const toml::node* buoyancy = root.get("buoyancy"))
    problem.buoyancy = read_buoyancy(as_table(*buoyancy, "buoyancy"));
  return problem;
}

} // namespace

Case read_case(const std::filesystem::path& file) {
  return read_case(file, {});
}

bool is_case_file(const std::filesystem::path& file) {
  return file.extension() == ".toml";
}

Case read_question(const std::filesystem::path& file, const QuestionOptions& options) {
  Case problem;
  if (is_case_file(file)) {
    problem = read_case(file, options);
  } else {
    problem.name = file.stem().string();
    const FaceInput input = overridden(FlowAlong{}, options);
    problem.packing = pfv::read_packing(file, periodic_axes(input));
    problem.faces = face_conditions(input, problem.packing.box);
  }
  if (options.viscosity) {
    problem.fluid.viscosity = *options.viscosity;
    validate(problem.fluid);
  }
  return problem;
}

} // namespace pfv
