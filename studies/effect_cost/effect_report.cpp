#include "studies/effect_cost/effect_report.hpp"

#include "studies/runner/number_text.hpp"
#include "studies/runner/provenance.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <map>

namespace studies {
namespace {

double whole_step(const Row& row) {
  return row.stages.empty() ? 0 : row.stages.front().cpu_seconds;
}

/// Answered rows of an effect by repeat.
std::map<int, const Row*> answered(std::span<const Row> rows, const std::string& id) {
  std::map<int, const Row*> found;
  for (const Row& row : rows)
    if (row.case_id == id && row.status == Status::answered)
      found[row.repeats] = &row;
  return found;
}

std::string microseconds(double cpu_seconds) {
  const double value = 1e6 * cpu_seconds;
  return fmt::format("{:.{}f}", value, std::abs(value) < 100 ? 1 : 0);
}

std::string range(const Spread& of) {
  return fmt::format("{} to {}", microseconds(of.least), microseconds(of.most));
}

/// "Of 12 effects, 9 cost something that the turns agree on, 3 are unresolved."
std::string outcome(std::span<const EffectCost> costs) {
  std::size_t asked = 0, resolved = 0, unresolved = 0, failed = 0;
  for (const EffectCost& cost : costs) {
    failed += cost.all ? 0 : 1;
    if (!cost.extra)
      continue;
    ++asked;
    ++(cost.is_resolved() ? resolved : unresolved);
  }
  return fmt::format(
      "Of {} effects held against the scene without them, the turns agree on the sign of the cost of {}; "
      "{} are unresolved, {} failed.",
      asked, resolved, unresolved, failed);
}

/// What each effect adds to a step, from the least to the most over the turns.
Plot effect_plot(const EffectStudy& study, std::span<const EffectCost> costs) {
  Plot plot{"CPU time of a step with each effect: medians, and from the least to the most over the turns.",
            {"µs per step", Scale::logarithmic},
            {},
            {{"", Drawn::points, 0, {}}}};
  for (std::size_t i = 0; i < costs.size(); ++i) {
    if (!costs[i].all)
      continue;
    const Spread& all = *costs[i].all;
    PlotPoint point{1e6 * all.median, static_cast<double>(plot.y.categories.size())};
    point.x_error = 1e6 * std::max(all.most - all.median, all.median - all.least);
    plot.y.categories.push_back(study.effects[i].label);
    plot.series[0].points.push_back(point);
  }
  plot.height = 100 + 22 * static_cast<int>(plot.y.categories.size());
  return plot;
}

std::string label_of(const EffectStudy& study, const std::string& id) {
  const auto found = std::ranges::find(study.effects, id, &Effect::id);
  return found == study.effects.end() ? "" : found->label;
}

} // namespace

Spread spread_of(std::vector<double> values) {
  std::ranges::sort(values);
  const std::size_t middle = values.size() / 2;
  return {values.size() % 2 == 1 ? values[middle] : 0.5 * (values[middle - 1] + values[middle]), values.front(),
          values.back()};
}

std::vector<EffectCost> effect_costs(const EffectStudy& study, std::span<const Row> rows) {
  std::vector<EffectCost> costs;
  for (const Effect& effect : study.effects) {
    EffectCost cost;
    cost.id = effect.id;
    const auto with = answered(rows, effect.id), without = answered(rows, effect.beside);
    std::vector<double> all, extra, memory;
    for (const auto& [repeat, row] : with) {
      all.push_back(whole_step(*row));
      memory.push_back(static_cast<double>(row->memory_bytes));
      cost.pores = row->unknowns;
      if (const auto pair = without.find(repeat); pair != without.end())
        extra.push_back(whole_step(*row) - whole_step(*pair->second));
    }
    if (!all.empty()) {
      cost.all = spread_of(all);
      cost.memory_bytes = static_cast<std::size_t>(spread_of(memory).median);
    }
    if (!extra.empty())
      cost.extra = spread_of(extra);
    for (const Row& row : rows)
      if (row.case_id == effect.id && row.status != Status::answered)
        cost.trouble = row.message;
    costs.push_back(cost);
  }
  return costs;
}

Table effect_table(const EffectStudy& study, std::span<const EffectCost> costs) {
  Table table{{{"effect"},
               {"beside"},
               {"µs per step", true},
               {"least to most", true},
               {"of it the effect, µs", true},
               {"least to most", true},
               {"of the step without it", true},
               {"memory", true}},
              {}};
  for (std::size_t i = 0; i < costs.size(); ++i) {
    const Effect& effect = study.effects[i];
    const EffectCost& cost = costs[i];
    std::vector<std::string> line{effect.label, label_of(study, effect.beside), "", "", "", "", "", ""};
    if (cost.all) {
      line[2] = microseconds(cost.all->median);
      line[3] = range(*cost.all);
      line[7] = bytes(static_cast<double>(cost.memory_bytes));
    } else
      line[2] = "failed";
    if (cost.extra) {
      const double without = cost.all->median - cost.extra->median;
      line[4] = cost.is_resolved() ? microseconds(cost.extra->median) : "unresolved";
      line[5] = range(*cost.extra);
      line[6] = cost.is_resolved() && without > 0 ? percent(cost.extra->median / without) : "";
    }
    table.rows.push_back(line);
  }
  return table;
}

Table effect_stages(const EffectStudy& study, std::span<const Row> rows) {
  std::vector<std::string> stages;
  for (const Row& row : rows)
    for (const pfv::Stage& stage : row.stages)
      if (stage.name != "all" && std::ranges::find(stages, stage.name) == stages.end())
        stages.push_back(stage.name);
  Table table{{{"effect"}}, {}};
  for (const std::string& stage : stages)
    table.columns.push_back({stage, true});
  for (const Effect& effect : study.effects) {
    std::vector<std::string> line{effect.label};
    const auto runs = answered(rows, effect.id);
    for (const std::string& stage : stages) {
      std::vector<double> values;
      for (const auto& [repeat, row] : runs)
        for (const pfv::Stage& one : row->stages)
          if (one.name == stage)
            values.push_back(one.cpu_seconds);
      line.push_back(values.empty() ? "" : microseconds(spread_of(values).median));
    }
    table.rows.push_back(line);
  }
  return table;
}

Document effect_report(const EffectStudy& study, bool quick, std::span<const Row> rows) {
  Document page{study.title, {}};
  page.add(Paragraph{study.question});
  if (quick)
    page.add(Paragraph{"This is the quick plan: fewer grains, steps and repeats than the study's full plan."});
  if (rows.empty()) {
    page.add(Paragraph{"Nothing has been run yet."});
    return page;
  }
  const auto costs = effect_costs(study, rows);
  std::size_t spheres = 0;
  for (const Row& row : rows)
    spheres = std::max(spheres, row.spheres);
  page.add(Paragraph{std::string(outcome_lead) + outcome(costs)});
  page.add(Heading{"Results"});
  page.add(effect_plot(study, costs));
  page.add(effect_table(study, costs));
  page.add(Paragraph{fmt::format(
      "{} grains. CPU time of a step, one thread, start left out, each of the {} runs a process of "
      "its own, in turn. *Of it the effect* is the step with the effect less the step of the scene it is beside, from "
      "the same turn: medians, least and most over the turns. It is *unresolved* when the turns do not agree on its "
      "sign. Memory is what the scene adds to the process.",
      spheres, study.repeats)});
  page.add(Heading{"Where the time goes"});
  page.add(Paragraph{"µs per step, medians. An empty cell is a stage that there is not."});
  page.add(effect_stages(study, rows));
  for (const EffectCost& cost : costs)
    if (!cost.trouble.empty())
      page.add(Paragraph{fmt::format("{} failed: {}", cost.id, cost.trouble)});
  page.add(Heading{"Where the numbers come from"});
  page.add(provenance(rows));
  return page;
}

std::string effects_json(const EffectStudy& study, std::span<const Row> rows) {
  const auto spread = [](const Spread& of) {
    return nlohmann::ordered_json{{"median", of.median}, {"least", of.least}, {"most", of.most}};
  };
  nlohmann::ordered_json json;
  json["study"] = study.name;
  auto& list = json["effects"] = nlohmann::ordered_json::array();
  const auto costs = effect_costs(study, rows);
  for (std::size_t i = 0; i < costs.size(); ++i) {
    nlohmann::ordered_json one{{"id", costs[i].id}, {"beside", study.effects[i].beside}};
    if (costs[i].all)
      one["cpu_seconds"] = spread(*costs[i].all);
    if (costs[i].extra)
      one["extra_cpu_seconds"] = spread(*costs[i].extra);
    one["memory_bytes"] = costs[i].memory_bytes;
    one["pores"] = costs[i].pores;
    if (!costs[i].trouble.empty())
      one["trouble"] = costs[i].trouble;
    list.push_back(one);
  }
  return json.dump(2) + "\n";
}

} // namespace studies
