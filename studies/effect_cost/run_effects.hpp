#pragma once

#include "studies/effect_cost/effect_study.hpp"
#include "studies/runner/study_run.hpp"

#include <functional>
#include <string>

namespace studies {

/// Is told a line on what is going on.
using Tell = std::function<void(const std::string& line)>;

/// Rows of a study of effects: `case_id` is the effect, `repeats` which of its runs it is (from 1), `stages` the CPU
/// seconds of a step with "all" first, `unknowns` the pores.
///
/// Prepares the packing once, then does what is not stored yet, one process at a time: every effect once, every effect
/// a second time, so that a machine that slows down does so for all of them. Returns the rows of the plan by effect.
/// Throws pfv::InputError on a bad scene, pfv::SolveError when the preparation fails.
std::vector<Row> run_effects(const EffectStudy& study, const RunSettings& settings, const Tell& tell);

/// The stored rows of the plan, by effect and repeat, of the sources it was run with last; those of other scenes are
/// left out.
std::vector<Row> stored_effects(const EffectStudy& study, const WorkFolder& work);

} // namespace studies
