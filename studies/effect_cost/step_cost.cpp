#include "studies/effect_cost/step_cost.hpp"

#include "reference/memory_meter.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace studies {

StepCost step_cost(const pfv::Scene& scene, std::size_t warm_up, std::size_t steps) {
  const reference::MemoryMeter memory;
  pfv::Simulation simulation(scene);
  for (std::size_t n = 0; n < warm_up; ++n)
    simulation.advance();
  const std::vector<pfv::Stage> before = simulation.clock().stages();
  const double start = pfv::process_cpu_seconds();
  for (std::size_t n = 0; n < steps; ++n)
    simulation.advance();
  const double end = pfv::process_cpu_seconds();

  const auto count = static_cast<double>(steps);
  StepCost cost;
  cost.spheres = simulation.grains().grains.size();
  cost.pores = simulation.fluid() ? simulation.fluid()->network().pores.size() : 0;
  cost.memory_bytes = memory.bytes();
  cost.of_step.push_back({"all", (end - start) / count});
  for (const pfv::Stage& stage : simulation.clock().stages()) {
    const auto old = std::ranges::find(before, stage.name, &pfv::Stage::name);
    cost.of_step.push_back({stage.name, (stage.cpu_seconds - (old == before.end() ? 0 : old->cpu_seconds)) / count});
  }
  return cost;
}

std::string to_json(const StepCost& cost) {
  nlohmann::ordered_json json;
  json["spheres"] = cost.spheres;
  json["pores"] = cost.pores;
  json["memory_bytes"] = cost.memory_bytes;
  for (const pfv::Stage& stage : cost.of_step)
    json["of_step"].push_back({stage.name, stage.cpu_seconds});
  return json.dump() + "\n";
}

StepCost step_cost_from_json(const std::string& text) {
  const auto json = nlohmann::json::parse(text);
  StepCost cost;
  cost.spheres = json.at("spheres");
  cost.pores = json.at("pores");
  cost.memory_bytes = json.at("memory_bytes");
  for (const auto& stage : json.at("of_step"))
    cost.of_step.push_back({stage.at(0), stage.at(1)});
  return cost;
}

} // namespace studies
