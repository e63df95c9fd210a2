#pragma once

#include "studies/document/document.hpp"
#include "studies/effect_cost/effect_study.hpp"
#include "studies/runner/row.hpp"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace studies {

/// The median of repeated runs, and how far apart they are.
struct Spread {
  double median = 0, least = 0, most = 0;

  bool operator==(const Spread&) const = default;
};

/// Of one value or more.
Spread spread_of(std::vector<double> values);

/// What an effect costs in a step (CPU seconds).
struct EffectCost {
  std::string id;
  std::optional<Spread> all;   // of the scene with it; nothing when no run answered
  std::optional<Spread> extra; // with it, less without it in the same turn; nothing for the scene of all
  std::size_t memory_bytes = 0, pores = 0;
  std::string trouble; // last words of the runs that failed
  /// Whether the runs agree on the sign of what it costs.
  bool is_resolved() const { return extra && (extra->least > 0 || extra->most < 0); }
};

std::vector<EffectCost> effect_costs(const EffectStudy& study, std::span<const Row> rows);

/// Cost by effect, with and without it.
Table effect_table(const EffectStudy& study, std::span<const EffectCost> costs);
/// Microseconds of a step by stage and effect, medians.
Table effect_stages(const EffectStudy& study, std::span<const Row> rows);

/// The page: question, outcome, costs, where the time goes, where the numbers come from.
Document effect_report(const EffectStudy& study, bool quick, std::span<const Row> rows);
std::string effects_json(const EffectStudy& study, std::span<const Row> rows);

} // namespace studies
