#include "studies/runner/plan.hpp"

#include "pfv/problem/error.hpp"
#include "reference/method.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace studies {

namespace {

bool contains(const std::vector<std::string>& list, const std::string& name) {
  return std::ranges::find(list, name) != list.end();
}

void refuse_unknown(const Study& study, const std::vector<std::string>& wanted) {
  std::vector<std::string> names;
  for (const StudyMethod& method : study.methods)
    names.push_back(method.name);
  for (const std::string& name : wanted)
    if (!contains(names, name))
      throw pfv::InputError(
          fmt::format("study {} does not ask method '{}'; it asks {}", study.name, name, fmt::join(names, ", ")));
}

const std::vector<double>& mesh_sizes(const StudyCase& one, const StudyMethod& method, bool quick) {
  const auto own = one.mesh_sizes.find(method.name);
  return quick ? method.quick_mesh_sizes : own == one.mesh_sizes.end() ? method.mesh_sizes : own->second;
}

} // namespace

std::vector<PlannedRun> plan(const Study& study, const Scope& scope) {
  refuse_unknown(study, scope.methods);
  std::vector<PlannedRun> runs;
  for (const StudyCase& one : study.cases) {
    for (const StudyMethod& method : study.methods) {
      if (!contains(scope.quick ? one.quick_methods : one.methods, method.name) ||
          !(scope.methods.empty() || contains(scope.methods, method.name)))
        continue;
      if (!reference::find_method(method.name).convergence_order()) {
        runs.push_back({one.id, method.name, 1, method.ranks});
        continue;
      }
      for (const double mesh_size : mesh_sizes(one, method, scope.quick))
        runs.push_back({one.id, method.name, mesh_size, method.ranks});
    }
  }
  return runs;
}

} // namespace studies
