#include "studies/runner/cost.hpp"
#include "studies/runner/report.hpp"

#include <nlohmann/json.hpp>

namespace studies {

namespace {

using nlohmann::json;

template <class T>
json or_null(const std::optional<T>& value) {
  return value ? json(*value) : json(nullptr);
}

json written(const std::optional<Bounded>& bounded) {
  if (!bounded)
    return nullptr;
  return {{"value", bounded->value}, {"error", or_null(bounded->error)}, {"order", or_null(bounded->order)}};
}

json written(const std::optional<Difference>& difference) {
  if (!difference)
    return nullptr;
  return {{"value", difference->value},
          {"error", or_null(difference->error)},
          {"reference_error", or_null(difference->reference_error)},
          {"unresolved", difference->unresolved()}};
}

json written(const Result& result) {
  const Finding& finding = result.finding;
  const Row& row = finding.told();
  const Cost split = cost(row.stages);
  json object{{"case", finding.case_id},
              {"spheres", row.spheres},
              {"method", finding.method},
              {"status", name(row.status)},
              {"outcome", nullptr},
              {"because", result.comparison.because},
              {"reference", result.comparison.reference},
              {"unknowns", row.unknowns},
              {"permeability_m2", written(finding.permeability)},
              {"relative_bridge_error", finding.bridge_error},
              {"permeability_difference", written(result.comparison.permeability)},
              {"rms_force_difference", written(result.comparison.forces)},
              {"rms_pore_pressure_difference", written(result.comparison.pressures)},
              {"rms_throat_flux_difference", written(result.comparison.fluxes)},
              {"cpu_s", {{"mesh", split.mesh}, {"once", split.once}, {"solve", split.solve}}},
              {"memory_bytes", row.memory_bytes},
              {"keys", json::array()}};
  if (result.comparison.outcome)
    object["outcome"] = name(*result.comparison.outcome);
  for (const Row& one : finding.rows)
    object["keys"].push_back(one.key);
  return object;
}

} // namespace

std::string results_json(const Study& study, std::span<const Result> list) {
  json object{{"study", study.name}, {"results", json::array()}};
  for (const Result& result : list)
    object["results"].push_back(written(result));
  return object.dump(2) + '\n';
}

} // namespace studies
