#include "pfv/problem/case.hpp"

#include "pfv/problem/read_conditions.hpp"
#include "pfv/problem/read_parts.hpp"
#include "pfv/problem/toml_input.hpp"
#include "pfv/problem/validate.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace pfv {

namespace {

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

void take(Case& problem, ReadPacking read) {
  problem.packing = std::move(read.packing);
  problem.notes = std::move(read.notes);
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
  take(problem, read_packing(packing, file.parent_path(), periodic_axes(input), options.packing));
  problem.faces = face_conditions(input, problem.packing.box);
  problem.fluid = read_fluid(root);
  if (const toml::node* points = root.get("pressure_points"))
    problem.pressure_points = read_pressure_points(*points, problem.packing.box);
  const toml::node* faces = root.get("faces");
  located(faces ? *faces : root, [&] { validate_level(problem.faces, problem.pressure_points); });
  problem.buoyancy = read_buoyancy(root);
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
    take(problem, read_packing_file(file, options.packing, periodic_axes(input)));
    problem.faces = face_conditions(input, problem.packing.box);
  }
  if (options.viscosity) {
    problem.fluid.viscosity = *options.viscosity;
    validate(problem.fluid);
  }
  return problem;
}

} // namespace pfv
