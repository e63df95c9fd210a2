#include "pfv/command/flow_report.hpp"

#include "pfv/flow/choice.hpp"
#include "pfv/flow/permeability_error.hpp"

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
  line(flow.network.closed_throats, "throats closed: spheres cover them");
  line(flow.system.rounded_throats, "throats with a lost void or wetted surface, taken for round tubes");
  line(flow.system.isolated_pores, "pores isolated: no throat leads to a known pressure");
  line(flow.clamped_pores, "pores clamped: their pressure was round-off beyond those imposed");
  line(flow.system.held_pores, "pores held at zero: nothing else sets the level of the pressure");
  line(flow.network.flat_pores, "pores flat: they share the centre of a neighbour across them");
  line(flow.network.inverted_throats, "throats inverted: their pores are on the wrong sides, contracted");
  line(flow.network.hidden_spheres.size(), "spheres hidden by others: they feel no fluid force");
  return lines.empty() ? lines : "remedies\n" + lines;
}

nlohmann::ordered_json list(const Vec3& vector) {
  return {vector.x(), vector.y(), vector.z()};
}

} // namespace

std::string text_report(const Case& problem, const FlowOptions& options, const SteadyFlow& flow, const Clock& clock) {
  const Vec3 force = total_force(flow.forces);
  std::string text;
  const auto line = [&](const char* what, const std::string& value) { text += fmt::format("{:<14}{}\n", what, value); };
  line("case", problem.name);
  for (const std::string& note : problem.notes)
    line("packing", note);
  line("spheres", fmt::format("{}", problem.packing.spheres.size()));
  line("pores", fmt::format("{} ({} unknowns)", flow.network.pores.size(), flow.system.unknowns()));
  line("porosity", fmt::format("{:.6g}", flow.network.porosity()));
  if (flow.permeability)
    line("permeability", fmt::format("{:.6e} m^2", *flow.permeability));
  if (const auto error = permeability_error(options, problem.packing, flow.network.porosity());
      error && flow.permeability)
    line("its error", error->relative ? fmt::format("{:.2g} %, larger for one packing in ten", 100 * *error->relative)
                                      : "not known: " + error->outside);
  line("flux in", fmt::format("{:.6e} m^3/s", flow.flux_in));
  line("flux out", fmt::format("{:.6e} m^3/s (imbalance {:.1e})", flow.flux_out, flow.imbalance()));
  if (flow.flux_in + flow.flux_out == 0 && flow.network.closed_throats > 0)
    line("no way", fmt::format("for the fluid: {} throats are closed", flow.network.closed_throats));
  for (const Face face : all_faces)
    if (const auto pressure = flow.pumped[index(face)])
      line("pumped face", fmt::format("{} at {:.6e} Pa", face_names[index(face)], *pressure));
  for (std::size_t n = 0; n < flow.point_flux.size(); ++n)
    line("point", fmt::format("{} takes out {:.6e} m^3/s", n, flow.point_flux[n]));
  if (flow.mean_flux)
    line("mean flux",
         fmt::format("{:.6e} {:.6e} {:.6e} m/s", flow.mean_flux->x(), flow.mean_flux->y(), flow.mean_flux->z()));
  line("force", fmt::format("{:.6g} {:.6g} {:.6g} N on all spheres", force.x(), force.y(), force.z()));
  line("rules", fmt::format("conductance {}, walls {}", name_of(options.conductance), name_of(options.walls)));
  line("solver", fmt::format("{}, residual {:.1e}", flow.solver.name, flow.solver.residual));
  text += remedies(flow);
  text += "cpu seconds\n";
  for (const auto& stage : clock.stages())
    text += fmt::format("  {:<14}{:.3g}\n", stage.name, stage.cpu_seconds);
  return text;
}

std::string json_report(const Case& problem, const FlowOptions& options, const SteadyFlow& flow, const Clock& clock) {
  nlohmann::ordered_json json;
  json["case"] = problem.name;
  if (!problem.notes.empty())
    json["notes"] = problem.notes;
  json["digest"] = digest(problem);
  json["spheres"] = problem.packing.spheres.size();
  json["pores"] = flow.network.pores.size();
  json["throats"] = flow.network.throats.size();
  json["unknowns"] = flow.system.unknowns();
  json["porosity"] = flow.network.porosity();
  json["permeability"] = flow.permeability ? nlohmann::ordered_json(*flow.permeability) : nullptr;
  if (const auto error = permeability_error(options, problem.packing, flow.network.porosity());
      error && flow.permeability) {
    json["permeability_error"] =
        error->relative ? nlohmann::ordered_json(*error->relative * *flow.permeability) : nullptr;
    if (!error->outside.empty())
      json["outside_of_fit"] = error->outside;
  }
  json["flux_in"] = flow.flux_in;
  json["flux_out"] = flow.flux_out;
  json["flux_imbalance"] = flow.imbalance();
  for (const Face face : all_faces) {
    const std::string name(face_names[index(face)]);
    json["face_flux"][name] = flow.face_flux[index(face)];
    if (const auto pressure = flow.pumped[index(face)])
      json["face_pressure"][name] = *pressure;
  }
  if (!flow.point_flux.empty())
    json["point_flux"] = flow.point_flux;
  if (flow.mean_flux)
    json["mean_flux"] = list(*flow.mean_flux);
  const Vec3 force = total_force(flow.forces);
  json["force_on_spheres"] = list(force);
  json["contracted_throats"] = flow.system.contracted_throats;
  json["closed_throats"] = flow.network.closed_throats;
  json["rounded_throats"] = flow.system.rounded_throats;
  json["isolated_pores"] = flow.system.isolated_pores;
  json["clamped_pores"] = flow.clamped_pores;
  json["held_pores"] = flow.system.held_pores;
  json["flat_pores"] = flow.network.flat_pores;
  json["inverted_throats"] = flow.network.inverted_throats;
  json["hidden_spheres"] = flow.network.hidden_spheres;
  json["conductance"] = name_of(options.conductance);
  json["walls"] = name_of(options.walls);
  json["solver"] = {{"name", flow.solver.name},
                    {"iterations", flow.solver.iterations},
                    {"matrix_entries", flow.solver.matrix_entries},
                    {"factor_entries", flow.solver.factor_entries},
                    {"operator_complexity", flow.solver.operator_complexity},
                    {"memory_bytes", flow.solver.memory_bytes},
                    {"residual", flow.solver.residual}};
  auto& stages = json["stages"] = nlohmann::ordered_json::object();
  for (const auto& stage : clock.stages())
    stages[stage.name] = stage.cpu_seconds;
  json["cpu_seconds"] = process_cpu_seconds();
  json["peak_memory_bytes"] = peak_memory_bytes();
  return json.dump(2) + "\n";
}

} // namespace pfv
