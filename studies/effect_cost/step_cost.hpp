#pragma once

#include "pfv/clock.hpp"
#include "pfv/simulation/simulation.hpp"

#include <string>
#include <vector>

namespace studies {

/// What a scene takes, its start left out.
struct StepCost {
  std::size_t spheres = 0, pores = 0;
  std::size_t memory_bytes = 0;    // that the scene added to the process
  std::vector<pfv::Stage> of_step; // CPU seconds of a step by stage; the first, "all", is the whole of it

  bool operator==(const StepCost&) const = default;
};

/// Advances the scene by `warm_up` steps and then by `steps` that count. Throws pfv::SolveError.
StepCost step_cost(const pfv::Scene& scene, std::size_t warm_up, std::size_t steps);

std::string to_json(const StepCost& cost);
StepCost step_cost_from_json(const std::string& text);

} // namespace studies
