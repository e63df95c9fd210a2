#include "studies/runner/result.hpp"

namespace studies {

namespace {

std::vector<Row> rows_of(std::span<const Row> rows, const std::string& case_id, const std::string& method) {
  std::vector<Row> chosen;
  for (const Row& row : rows)
    if (row.case_id == case_id && row.method == method)
      chosen.push_back(row);
  return chosen;
}

} // namespace

const Finding* with_permeability(std::span<const Result> results, const std::string& case_id,
                                 const std::string& method) {
  for (const Result& result : results)
    if (result.finding.case_id == case_id && result.finding.method == method && result.finding.permeability)
      return &result.finding;
  return nullptr;
}

std::vector<Result> results(const Study& study, std::span<const Row> rows, const std::filesystem::path& answers) {
  std::vector<Result> list;
  for (const StudyCase& one : study.cases) {
    std::vector<Finding> findings;
    for (const StudyMethod& method : study.methods)
      if (auto chosen = rows_of(rows, one.id, method.name); !chosen.empty())
        findings.push_back(find(std::move(chosen), answers));
    const Finding* reference = nullptr;
    for (const Finding& finding : findings)
      if (finding.method == study.reference)
        reference = &finding;
    for (const Finding& finding : findings)
      list.push_back({finding, compare(finding, study.reference, reference, study.tolerance)});
  }
  return list;
}

} // namespace studies
