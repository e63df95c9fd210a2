#include "studies/motion/stability/stability.hpp"

#include "studies/motion/stability/continuity_trials.hpp"
#include "studies/motion/stability/flip_trials.hpp"
#include "studies/motion/stability/passivity_trials.hpp"
#include "studies/motion/stability/refusal_trials.hpp"
#include "studies/motion/stability/steady_trials.hpp"
#include "studies/motion/stability/step_trials.hpp"

#include "reference/yade/program.hpp"

namespace studies {

std::vector<Trial> hard_cases(bool quick) {
  std::vector<Trial> all;
  const bool asks_the_original = !reference::yade::missing_program();
  for (auto* group : {steady_trials, jitter_trials, gap_trials, refusal_trials, flip_trials, renewal_trials,
                      steady_motion_trials, explicit_trials, implicit_trials, resistance_trials, energy_trials})
    for (Trial& trial : group())
      if (trial.quick || !quick) {
        if (!asks_the_original)
          trial.theirs = nullptr;
        all.push_back(std::move(trial));
      }
  return all;
}

std::vector<TrialRow> tried_all(const std::vector<Trial>& trials, const Say& say) {
  std::vector<TrialRow> rows;
  for (const Trial& trial : trials) {
    say("trying hard cases", static_cast<double>(rows.size()) / static_cast<double>(trials.size()));
    rows.push_back(tried(trial));
  }
  return rows;
}

ExperimentReport run_stability(bool quick, const Say& say) {
  return stability_report(tried_all(hard_cases(quick), say));
}

} // namespace studies
