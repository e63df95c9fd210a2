#include "reference/yade/flow_engine.hpp"

#include "pfv/problem/error.hpp"
#include "pfv/problem/text.hpp"
#include "reference/temporary_folder.hpp"
#include "reference/yade/program.hpp"

#include <cmath>
#include <fmt/format.h>
#include <fstream>
#include <nlohmann/json.hpp>

namespace reference::yade {

extern const char* const flow_engine_py;

namespace {

using nlohmann::json;

// CHOLMOD called directly; 3 is the same through Eigen, 0 Gauss-Seidel, 1 and 2 return without having solved.
constexpr int direct_solver = 4;

pfv::Packing in_units(const pfv::Packing& packing, double length) {
  const pfv::Vec3& origin = packing.box.lower;
  pfv::Packing scaled{{pfv::Vec3::Zero(), packing.box.size() / length}, packing.spheres};
  for (auto& [centre, radius] : scaled.spheres) {
    centre = (centre - origin) / length;
    radius /= length;
  }
  return scaled;
}

void write_question(const std::filesystem::path& folder, const pfv::Packing& packing, std::span<const pfv::Vec3> points,
                    const pfv::PermeabilitySetup& setup) {
  std::ofstream(folder / "question.json") << json{{"axis", pfv::index(setup.axis)}, {"solver", direct_solver}};
  std::ofstream file(folder / "packing.txt");
  pfv::write_packing(in_units(packing, setup.length), file);
  std::ofstream places(folder / "points.txt");
  for (const pfv::Vec3& point : points)
    places << pfv::shortest((point - packing.box.lower) / setup.length, " ") << '\n';
  std::ofstream(folder / "flow_engine.py") << flow_engine_py;
}

// What is not a number arrives as null.
double finite(const json& value, const char* what) {
  if (!value.is_number())
    throw pfv::SolveError(fmt::format("FlowEngine's {} is not a finite number", what));
  return value;
}

Iteration iteration(const json& stages) {
  return {stages.at("network"), stages.at("solve"), stages.at("forces")};
}

Reply parse(const json& object) {
  Reply reply;
  reply.version = object.at("version");
  reply.cells = object.at("cells");
  reply.flux_in = finite(object.at("flux_in"), "flux through a pressure face");
  reply.flux_out = finite(object.at("flux_out"), "flux through a pressure face");
  for (const json& force : object.at("forces")) {
    reply.forces.emplace_back();
    for (int i = 0; i < 3; ++i)
      reply.forces.back()[i] = finite(force.at(static_cast<std::size_t>(i)), "force on a sphere");
  }
  for (const json& pressure : object.at("pressures"))
    reply.pressures.push_back(pressure.is_number() ? pressure.get<double>() : std::nan(""));
  reply.first = iteration(object.at("first"));
  reply.repeated = iteration(object.at("repeated"));
  reply.memory_before = object.at("memory_before");
  reply.peak_memory = object.at("peak_memory");
  return reply;
}

Reply in_si(Reply reply, double length, double outlet, double drop, double viscosity) {
  reply.flux_in *= drop * std::pow(length, 3) / viscosity;
  reply.flux_out *= drop * std::pow(length, 3) / viscosity;
  for (pfv::Vec3& force : reply.forces)
    force *= drop * length * length;
  for (double& pressure : reply.pressures)
    pressure = outlet + drop * pressure;
  return reply;
}

} // namespace

Reply run_flow_engine(const pfv::Case& problem, std::span<const pfv::Vec3> points, double wall_limit) {
  const TemporaryFolder folder("yade");
  const auto setup = pfv::permeability_setup(problem).value();
  write_question(folder.path(), problem.packing, points, setup);
  const auto& outlet = problem.faces[static_cast<std::size_t>(index(pfv::lower_face(setup.axis)))];
  run_script(folder.path(), "flow_engine.py", wall_limit);
  try {
    return in_si(parse(json::parse(pfv::read_text(folder.path() / "reply.json"))), setup.length,
                 std::get<pfv::Pressure>(outlet).value, setup.pressure_drop.value(), problem.fluid.viscosity);
  } catch (const pfv::InputError& error) {
    throw pfv::SolveError(fmt::format("yade left no reply: {}", error.what()));
  } catch (const json::exception& error) {
    throw pfv::SolveError(fmt::format("yade's reply cannot be read: {}", error.what()));
  }
}

} // namespace reference::yade
