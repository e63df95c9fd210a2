#include "studies/runner/finding.hpp"

#include "pfv/problem/text.hpp"
#include "reference/answer.hpp"
#include "studies/runner/own_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
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

Field components(const std::optional<std::vector<pfv::Vec3>>& forces) {
  if (!forces)
    return std::nullopt;
  std::vector<double> list;
  for (const pfv::Vec3& force : *forces)
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

std::optional<double> count_in(const Answers& answers, const char* name) {
  for (const auto& answer : answers)
    if (answer)
      if (const auto found = answer->counts.find(name); found != answer->counts.end())
        return found->second;
  return std::nullopt;
}

bool has_answer(const Row& row) {
  return row.status == Status::answered;
}

std::optional<Bounded> bounded_permeability(const std::vector<Row>& rows, const Answers& answers) {
  std::vector<Sample> samples;
  std::optional<double> order;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (!has_answer(rows[i]))
      continue;
    if (!rows[i].permeability)
      return std::nullopt;
    const double k = *rows[i].permeability;
    samples.push_back({rows[i].mesh_size, k, answers[i] ? std::abs(k) * noise(*answers[i]) : 0});
    order = rows[i].convergence_order;
  }
  return extrapolate(samples, order);
}

// Of the finest mesh, which has the bridges as they are meant to be.
double bridge_error_of_finest(const std::vector<Row>& rows, const Answers& answers) {
  for (std::size_t i = rows.size(); i-- > 0;)
    if (has_answer(rows[i]))
      return answers[i] ? bridge_error(*answers[i]) : 0;
  return 0;
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
  if (std::ranges::none_of(rows, has_answer))
    return finding;
  finding.permeability = bounded_permeability(rows, read);
  if (finding.permeability && finding.permeability->error) {
    finding.bridge_error = bridge_error_of_finest(rows, read);
    *finding.permeability->error += finding.bridge_error * std::abs(finding.permeability->value);
  }
  finding.forces =
      bounded(rows, read, [](const reference::Answer& answer) { return components(answer.sphere_forces); });
  finding.viscous_forces =
      bounded(rows, read, [](const reference::Answer& answer) { return components(answer.sphere_viscous_forces); });
  finding.pore_pressures = bounded(rows, read, pore_pressures);
  finding.throat_fluxes = bounded(rows, read, [](const reference::Answer& answer) { return answer.facet_fluxes; });
  finding.pressure_drop = count_in(read, reference::pressure_drop_count);
  finding.free_level = count_in(read, free_level_count).has_value();
  finding.sauter_diameter = count_in(read, reference::sauter_diameter_count);
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
