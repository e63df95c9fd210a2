#include "pfv/command/flow_report.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace pfv {
namespace {

Vec3 total_force(const FluidForces& forces) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t k = 0; k < forces.pressure.size(); ++k)
    sum += forces.of_flow(k);
  return sum;
}

std::string remedies(const SteadyFlow& flow) {
  std::string lines;
  const auto line = [&](std::size_t count, const char* what) {
    if (count > 0)
      lines += fmt::format("  {:<8} {}\n", count, what);
  };
  line(flow.system.contracted_throats, "throats contracted: their two pores (nearly) coincide");
  line(flow.system.raised_throats, "throats without fluid area, raised to 1e-6 of the median conductance");
  line(flow.system.isolated_pores, "pores isolated: no throat leads to a face with a pressure");
  line(flow.network.hidden_spheres.size(), "spheres hidden by others: they feel no fluid force");
  return lines.empty() ? lines : "remedies\n" + lines;
}

} // namespace

std::string text_report(const Case& problem, const SteadyFlow& flow, const Clock& clock) {
  const Vec3 force = total_force(flow.forces);
  std::string text;
  const auto line = [&](const char* what, const std::string& value) { text += fmt::format("{:<14}{}\n", what, value); };
  line("case", problem.name);
  line("spheres", fmt::format("{}", problem.packing.spheres.size()));
  line("pores", fmt::format("{} ({} unknowns)", flow.network.pores.size(), flow.system.unknowns()));
  line("porosity", fmt::format("{:.6g}", flow.network.porosity()));
  if (flow.permeability)
    line("permeability", fmt::format("{:.6e} m^2", *flow.permeability));
  line("flux in", fmt::format("{:.6e} m^3/s", flow.flux_in));
  line("flux out", fmt::format("{:.6e} m^3/s (in/out - 1 = {:.1e})", flow.flux_out, flow.flux_in / flow.flux_out - 1));
  line("force", fmt::format("{:.6g} {:.6g} {:.6g} N on all spheres", force.x(), force.y(), force.z()));
  line("solver", fmt::format("{}, residual {:.1e}", flow.solver.name, flow.solver.residual));
  text += remedies(flow);
  text += "cpu seconds\n";
  for (const auto& stage : clock.stages())
    text += fmt::format("  {:<14}{:.3g}\n", stage.name, stage.cpu_seconds);
  return text;
}

std::string json_report(const Case& problem, const SteadyFlow& flow, const Clock& clock) {
  nlohmann::ordered_json json;
  json["case"] = problem.name;
  json["digest"] = digest(problem);
  json["spheres"] = problem.packing.spheres.size();
  json["pores"] = flow.network.pores.size();
  json["throats"] = flow.network.throats.size();
  json["unknowns"] = flow.system.unknowns();
  json["porosity"] = flow.network.porosity();
  json["permeability"] = flow.permeability ? nlohmann::ordered_json(*flow.permeability) : nullptr;
  json["flux_in"] = flow.flux_in;
  json["flux_out"] = flow.flux_out;
  const Vec3 force = total_force(flow.forces);
  json["force_on_spheres"] = {force.x(), force.y(), force.z()};
  json["contracted_throats"] = flow.system.contracted_throats;
  json["raised_throats"] = flow.system.raised_throats;
  json["isolated_pores"] = flow.system.isolated_pores;
  json["hidden_spheres"] = flow.network.hidden_spheres;
  json["solver"] = {{"name", flow.solver.name},
                    {"iterations", flow.solver.iterations},
                    {"factor_entries", flow.solver.factor_entries},
                    {"residual", flow.solver.residual}};
  auto& stages = json["stages"] = nlohmann::ordered_json::object();
  for (const auto& stage : clock.stages())
    stages[stage.name] = stage.cpu_seconds;
  json["cpu_seconds"] = process_cpu_seconds();
  json["peak_memory_bytes"] = peak_memory_bytes();
  return json.dump(2) + "\n";
}

} // namespace pfv
