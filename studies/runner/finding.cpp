#include "studies/runner/finding.hpp"

#include "pfv/problem/text.hpp"
#include "reference/answer.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace studies {

namespace {

using Field = std::optional<std::vector<double>>;

Field components(const reference::Answer& answer) {
  if (!answer.sphere_forces)
    return std::nullopt;
  std::vector<double> list;
  for (const pfv::Vec3& force : *answer.sphere_forces)
    list.insert(list.end(), {force.x(), force.y(), force.z()});
  return list;
}

// The samples begin with the pores.
Field pore_pressures(const reference::Answer& answer) {
  const auto pores = answer.counts.find(reference::sampled_pores_count);
  if (!answer.point_pressures || pores == answer.counts.end())
    return std::nullopt;
  const auto& all = *answer.point_pressures;
  return std::vector(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(pores->second));
}

// What all answers have, each of another mesh.
template <class Take>
std::optional<BoundedField> bounded(const std::vector<reference::Answer>& answers, std::optional<double> order,
                                    Take take) {
  std::vector<double> mesh_sizes;
  std::vector<std::vector<double>> fields;
  for (const reference::Answer& answer : answers) {
    Field field = take(answer);
    if (!field)
      return std::nullopt;
    mesh_sizes.push_back(answer.mesh_size);
    fields.push_back(std::move(*field));
  }
  return extrapolate_field(mesh_sizes, fields, order);
}

// Nothing when one is missing.
std::vector<reference::Answer> read_answers(const std::vector<Row>& answered, const std::filesystem::path& answers) {
  std::vector<reference::Answer> list;
  for (const Row& row : answered) {
    const auto file = answer_file(answers, row.key);
    if (!std::filesystem::exists(file))
      return {};
    list.push_back(reference::answer_from_json(pfv::read_text(file)));
    list.back().mesh_size = row.mesh_size;
  }
  return list;
}

void add_fields(const std::vector<reference::Answer>& answers, std::optional<double> order, Finding& finding) {
  if (answers.empty())
    return;
  finding.forces = bounded(answers, order, components);
  finding.pore_pressures = bounded(answers, order, pore_pressures);
  finding.throat_fluxes = bounded(answers, order, [](const reference::Answer& answer) { return answer.facet_fluxes; });
  if (const auto drop = answers.back().counts.find(reference::pressure_drop_count); drop != answers.back().counts.end())
    finding.pressure_drop = drop->second;
}

std::optional<Bounded> bounded_permeability(const std::vector<Row>& answered) {
  std::vector<Sample> samples;
  for (const Row& row : answered) {
    if (!row.permeability)
      return std::nullopt;
    samples.push_back({row.mesh_size, *row.permeability});
  }
  return extrapolate(samples, answered.back().convergence_order);
}

bool has_answer(const Row& row) {
  return row.status == Status::answered;
}

} // namespace

const Row& Finding::told() const {
  const auto finest = std::find_if(rows.rbegin(), rows.rend(), has_answer);
  return finest != rows.rend() ? *finest : rows.back();
}

std::string Finding::trouble() const {
  const auto found = std::ranges::find_if_not(rows, has_answer);
  return found == rows.end()
             ? ""
             : fmt::format("mesh size {}: {}: {}", found->mesh_size, name(found->status), found->message);
}

Finding find(std::vector<Row> rows, const std::filesystem::path& answers) {
  std::ranges::sort(rows, std::ranges::greater{}, &Row::mesh_size);
  Finding finding{rows.front().case_id, rows.front().method, rows, {}};
  std::vector<Row> answered;
  std::ranges::copy_if(rows, std::back_inserter(answered), has_answer);
  if (answered.empty())
    return finding;
  finding.permeability = bounded_permeability(answered);
  add_fields(read_answers(answered, answers), answered.back().convergence_order, finding);
  return finding;
}

std::filesystem::path answer_file(const std::filesystem::path& answers, const std::string& key) {
  return answers / (key + ".json");
}

} // namespace studies
