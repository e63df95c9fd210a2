#include "pfv/command/run_report.hpp"

#include "pfv/flow/choice.hpp"
#include "pfv/grains/contact_list.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

namespace pfv {
namespace {

std::string words(const Vec3& v) {
  return fmt::format("{:g} {:g} {:g}", v.x(), v.y(), v.z());
}

std::string words(double value) {
  return fmt::format("{:g}", value);
}

/// Its name and the values of its keys.
std::string words(const BodyForce& force) {
  std::string text(name_of(force));
  std::visit(
      [&](auto is) {
        for_each_key(is, [&](std::string_view, auto& value, std::string_view unit) {
          text += fmt::format(", {} {}", words(value), unit);
        });
      },
      force);
  return text;
}

std::string words(const StepLimits& limits) {
  std::string text = fmt::format("{:.3g} s of the contacts", limits.contact);
  if (limits.viscous)
    text += fmt::format(", {:.3g} s of the fluid", *limits.viscous);
  if (limits.lubrication)
    text += fmt::format(", {:.3g} s of the lubrication", *limits.lubrication);
  return text;
}

/// Kinetic and elastic energy (J), half a step apart.
std::pair<double, double> stored(const Simulation& simulation) {
  const GrainCycle& cycle = simulation.grains();
  return {kinetic_energy(cycle.grains, cycle.scene.walls), elastic_energy(cycle.grains, cycle.contacts)};
}

} // namespace

std::vector<std::string> effects_of(const Scene& scene) {
  const GrainScene& grains = scene.grains;
  std::vector<std::string> effects{fmt::format("contacts, {}", name_of(grains.law))};
  if (grains.cohesion)
    effects.push_back(fmt::format("cohesion, {:g} Pa in tension, {:g} Pa in shear", grains.cohesion->tensile_strength,
                                  grains.cohesion->shear_strength));
  if (grains.damping.share > 0)
    effects.push_back(fmt::format("local damping, {:g}", grains.damping.share));
  for (const BodyForce& force : grains.forces)
    effects.push_back(words(force));
  if (grains.lubrication) {
    std::vector<std::string_view> resists;
    for (const FilmMotion motion : grains.lubrication->resists)
      resists.push_back(film_motion_names[static_cast<std::size_t>(motion)]);
    effects.push_back(fmt::format("lubrication, {:g} Pa s, gaps of {:g} to {:g} of the smaller radius, {}",
                                  grains.lubrication->viscosity, grains.lubrication->roughness,
                                  grains.lubrication->reach, fmt::join(resists, ", ")));
  }
  if (grains.growth)
    effects.push_back(
        fmt::format("growth of radii, {:g} 1/s at first, to {:g} Pa", grains.growth->rate, grains.growth->stress));
  if (scene.fluid) {
    effects.push_back(
        fmt::format("pressure and viscous force, {:g} Pa s, {}", scene.fluid->fluid.viscosity, name_of(scene.scheme)));
    if (scene.fluid->compressible)
      effects.push_back(fmt::format("compressible fluid, {:g} Pa", scene.fluid->compressible->bulk_modulus));
  }
  return effects;
}

std::string opening_report(const Scene& scene, const Simulation& simulation) {
  std::string text;
  const auto line = [&](const char* what, const std::string& value) { text += fmt::format("{:<14}{}\n", what, value); };
  line("scene", scene.name);
  for (const std::string& note : scene.notes)
    line("packing", note);
  line("grains", fmt::format("{}", simulation.grains().grains.size()));
  if (const auto& fluid = simulation.fluid())
    line("pores", fmt::format("{}", fluid->network().pores.size()));
  for (const std::string& effect : effects_of(scene))
    line("effect", effect);
  const StepLimits& limits = simulation.limits();
  line("limit", words(limits));
  line("step", fmt::format("{:.3g} s", simulation.step()));
  if (simulation.steps() > 0)
    line("goes on", fmt::format("from {:.6g} s after {} steps", simulation.grains().time, simulation.steps()));
  return text;
}

std::string closing_report(const Simulation& simulation) {
  const GrainCycle& cycle = simulation.grains();
  const auto [kinetic, elastic] = stored(simulation);
  const EnergyBalance& energy = cycle.energy;
  std::string text;
  const auto line = [&](const char* what, const std::string& value) { text += fmt::format("{:<14}{}\n", what, value); };
  line("time", fmt::format("{:.6g} s after {} steps", cycle.time, simulation.steps()));
  line("box", words(cycle.grains.packing.box.size()) + " m");
  line("contacts", fmt::format("{}", contact_list(cycle.grains, cycle.contacts).size()));
  line("unbalanced", fmt::format("{:.3g}", cycle.unbalanced_force()));
  if (cycle.scene.cohesion)
    line("broken bonds", fmt::format("{}", cycle.broken_bonds));
  if (cycle.scene.growth)
    line("grown", fmt::format("radii by {:.6g}, to a mean stress of {:.6g} Pa", cycle.grains.grown,
                              mean_stress(cycle.stress())));
  if (const auto& films = cycle.films)
    line("films", fmt::format("{}, {} of them at the roughness", films->count, films->at_roughness));
  if (const auto& fluid = simulation.fluid()) {
    line("pressure", fmt::format("{:.6g} Pa, mean over the fluid", fluid->mean_pressure()));
    line("pores renewed",
         fmt::format("{} times in place, {} times triangulated anew", fluid->refreshed, fluid->rebuilt));
    line("iterations", fmt::format("{:.2f} for a pressure field",
                                   static_cast<double>(fluid->iterations) / static_cast<double>(fluid->solves)));
  }
  line("energy", fmt::format("{:.6g} J of loads, {:.6g} J of weight{}", energy.loads, energy.gravity,
                             cycle.scene.growth ? fmt::format(", {:.6g} J of growth", energy.growth) : ""));
  line("", fmt::format("{:.6g} J kinetic, {:.6g} J elastic", kinetic, elastic));
  line("", fmt::format("lost: {:.6g} J in friction, {:.6g} J in contact damping, {:.6g} J in local damping{}{}",
                       energy.friction, energy.contact_damping, energy.local_damping,
                       cycle.films ? fmt::format(", {:.6g} J in lubrication", energy.lubrication) : "",
                       simulation.fluid() ? fmt::format(", {:.6g} J to the fluid", energy.fluid) : ""));
  text += "cpu seconds\n";
  for (const auto& stage : simulation.clock().stages())
    text += fmt::format("  {:<14}{:.3g}\n", stage.name, stage.cpu_seconds);
  return text;
}

std::string json_report(const Scene& scene, const Simulation& simulation) {
  const GrainCycle& cycle = simulation.grains();
  const auto [kinetic, elastic] = stored(simulation);
  const Vec3 size = cycle.grains.packing.box.size();
  nlohmann::ordered_json json;
  json["scene"] = scene.name;
  if (!scene.notes.empty())
    json["notes"] = scene.notes;
  json["grains"] = cycle.grains.size();
  json["effects"] = effects_of(scene);
  json["contact_limit"] = simulation.limits().contact;
  if (simulation.limits().viscous)
    json["viscous_limit"] = *simulation.limits().viscous;
  if (simulation.limits().lubrication)
    json["lubrication_limit"] = *simulation.limits().lubrication;
  json["step"] = simulation.step();
  json["steps"] = simulation.steps();
  json["time"] = cycle.time;
  json["box"] = {size.x(), size.y(), size.z()};
  json["contacts"] = contact_list(cycle.grains, cycle.contacts).size();
  const Eigen::Matrix3d stress = cycle.stress();
  auto& rows = json["stress"] = nlohmann::ordered_json::array();
  for (const auto& row : stress.rowwise())
    rows.push_back({row[0], row[1], row[2]});
  json["unbalanced_force"] = cycle.unbalanced_force();
  if (cycle.scene.cohesion)
    json["broken_bonds"] = cycle.broken_bonds;
  if (cycle.scene.growth)
    json["grown"] = cycle.grains.grown;
  if (const auto& films = cycle.films)
    json["films"] = {{"count", films->count}, {"at_roughness", films->at_roughness}};
  if (const auto& fluid = simulation.fluid()) {
    json["mean_pressure"] = fluid->mean_pressure();
    json["pores"] = fluid->network().pores.size();
    json["refreshed"] = fluid->refreshed;
    json["rebuilt"] = fluid->rebuilt;
    json["iterations"] = fluid->iterations;
  }
  json["energy"] = {{"loads", cycle.energy.loads},
                    {"weight", cycle.energy.gravity},
                    {"kinetic", kinetic},
                    {"elastic", elastic},
                    {"friction", cycle.energy.friction},
                    {"contact_damping", cycle.energy.contact_damping},
                    {"local_damping", cycle.energy.local_damping}};
  if (cycle.scene.growth)
    json["energy"]["growth"] = cycle.energy.growth;
  if (cycle.films)
    json["energy"]["lubrication"] = cycle.energy.lubrication;
  if (simulation.fluid())
    json["energy"]["fluid"] = cycle.energy.fluid;
  auto& stages = json["stages"] = nlohmann::ordered_json::object();
  for (const auto& stage : simulation.clock().stages())
    stages[stage.name] = stage.cpu_seconds;
  json["cpu_seconds"] = process_cpu_seconds();
  json["peak_memory_bytes"] = peak_memory_bytes();
  return json.dump(2) + "\n";
}

std::string history_header() {
  return "time,size_x,size_y,size_z,contacts,unbalanced_force,kinetic,elastic,loads,weight,friction,contact_damping,"
         "local_damping,growth,lubrication,fluid,mean_pressure\n";
}

std::string history_row(const Simulation& simulation) {
  const GrainCycle& cycle = simulation.grains();
  const auto [kinetic, elastic] = stored(simulation);
  const Vec3 size = cycle.grains.packing.box.size();
  const EnergyBalance& energy = cycle.energy;
  return fmt::format("{},{},{},{},{},{:.4g},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{},{},{},{}\n", cycle.time,
                     size.x(), size.y(), size.z(), contact_list(cycle.grains, cycle.contacts).size(),
                     cycle.unbalanced_force(), kinetic, elastic, energy.loads, energy.gravity, energy.friction,
                     energy.contact_damping, energy.local_damping,
                     cycle.scene.growth ? fmt::format("{:.9g}", energy.growth) : "",
                     cycle.films ? fmt::format("{:.9g}", energy.lubrication) : "",
                     simulation.fluid() ? fmt::format("{:.9g}", energy.fluid) : "",
                     simulation.fluid() ? fmt::format("{:.9g}", simulation.fluid()->mean_pressure()) : "");
}

} // namespace pfv
