#include "studies/runner/finding.hpp"

#include "pfv/problem/text.hpp"
#include "reference/answer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace studies {

namespace {

using Answers = std::vector<std::optional<reference::Answer>>;
using Field = std::optional<std::vector<double>>;

std::string damaged(const std::string& how) {
  return "its stored answer is damaged: " + how;
}

// By row; nothing for a row without an answer or whose answer is not there. A row whose answer is damaged has failed.
Answers read_answers(std::vector<Row>& rows, const std::filesystem::path& answers) {
  Answers read(rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const auto file = answer_file(answers, rows[i].key);
    if (rows[i].status != Status::answered || !std::filesystem::exists(file))
      continue;
    try {
      read[i] = reference::answer_from_json(pfv::read_text(file));
    } catch (const std::runtime_error& error) {
      rows[i].status = Status::failed;
      rows[i].message = damaged(error.what());
    }
  }
  return read;
}

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

// What all answered rows have, each of another mesh.
template <class Take>
std::optional<BoundedField> bounded(const std::vector<Row>& rows, const Answers& answers, Take take) {
  std::vector<double> mesh_sizes;
  std::vector<std::vector<double>> fields;
  std::optional<double> order;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (rows[i].status != Status::answered)
      continue;
    Field field = answers[i] ? take(*answers[i]) : std::nullopt;
    if (!field)
      return std::nullopt;
    mesh_sizes.push_back(rows[i].mesh_size);
    fields.push_back(std::move(*field));
    order = rows[i].convergence_order;
  }
  return extrapolate_field(mesh_sizes, fields, order);
}

std::optional<double> pressure_drop(const Answers& answers) {
  for (const auto& answer : answers)
    if (answer)
      if (const auto drop = answer->counts.find(reference::pressure_drop_count); drop != answer->counts.end())
        return drop->second;
  return std::nullopt;
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
  const Answers read = read_answers(rows, answers);
  Finding finding{rows.front().case_id, rows.front().method, rows, {}};
  std::vector<Row> answered;
  std::ranges::copy_if(rows, std::back_inserter(answered), has_answer);
  if (answered.empty())
    return finding;
  finding.permeability = bounded_permeability(answered);
  finding.forces = bounded(rows, read, components);
  finding.pore_pressures = bounded(rows, read, pore_pressures);
  finding.throat_fluxes = bounded(rows, read, [](const reference::Answer& answer) { return answer.facet_fluxes; });
  finding.pressure_drop = pressure_drop(read);
  return finding;
}

std::filesystem::path answer_file(const std::filesystem::path& answers, const std::string& key) {
  return answers / (key + ".json");
}

std::optional<std::string> damage_of(const std::filesystem::path& answer_file) {
  if (!std::filesystem::exists(answer_file))
    return "its stored answer is gone";
  try {
    reference::answer_from_json(pfv::read_text(answer_file));
    return std::nullopt;
  } catch (const std::runtime_error& error) {
    return damaged(error.what());
  }
}

} // namespace studies
