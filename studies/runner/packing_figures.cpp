#include "studies/runner/packing_picture.hpp"

#include "studies/runner/case_store.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace studies {

namespace {

constexpr std::size_t most_figures = 3, most_spheres = 1000;

/// The reference when it knows the forces, else the first that does; nothing when none.
const Finding* with_forces(const Study& study, std::span<const Result> results, const std::string& case_id) {
  const Finding* found = nullptr;
  for (const Result& result : results)
    if (result.finding.case_id == case_id && result.finding.forces &&
        (!found || result.finding.method == study.reference))
      found = &result.finding;
  return found;
}

std::vector<double> magnitudes(const std::vector<double>& components) {
  std::vector<double> list;
  for (std::size_t i = 0; i + 2 < components.size(); i += 3)
    list.push_back(std::hypot(components[i], components[i + 1], components[i + 2]));
  return list;
}

} // namespace

std::vector<Figure> packing_figures(const Study& study, std::span<const Result> results) {
  std::vector<Figure> figures;
  std::set<std::size_t> sizes;
  for (const StudyCase& one : study.cases) {
    const auto asked = std::ranges::find(results, one.id, [](const Result& result) { return result.finding.case_id; });
    if (asked == results.end() || figures.size() == most_figures)
      continue;
    const std::size_t spheres = asked->finding.told().spheres;
    if (spheres == 0 || spheres > most_spheres || !sizes.insert(spheres).second)
      continue;
    Figure figure{fmt::format("{}: {} {}", one.label, spheres, spheres == 1 ? "sphere" : "spheres"), ""};
    try {
      const pfv::Packing packing = problem_of(one).packing;
      const Finding* forces = with_forces(study, results, one.id);
      std::vector<double> values = forces ? magnitudes(forces->forces->values) : std::vector<double>{};
      if (values.size() != packing.spheres.size())
        values.clear();
      else
        figure.caption += fmt::format(", coloured by the force of the fluid, {}", forces->method);
      figure.caption += '.';
      figure.picture = packing_picture(packing, values, "N", fmt::format("p{}-", figures.size()));
    } catch (const std::exception& error) {
      figure.why_not = error.what();
    }
    figures.push_back(std::move(figure));
  }
  return figures;
}

} // namespace studies
