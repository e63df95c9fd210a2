#include "studies/runner/finding.hpp"

#include "pfv/problem/text.hpp"
#include "reference/answer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace studies {

namespace {

std::string damaged(const std::string& how) {
  return "its stored answer is damaged: " + how;
}

// By row; nothing for a row without an answer or whose answer is not there. A row whose answer is damaged has failed.
std::vector<std::optional<reference::Answer>> read_answers(std::vector<Row>& rows,
                                                           const std::filesystem::path& answers) {
  std::vector<std::optional<reference::Answer>> read(rows.size());
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

std::optional<BoundedForces> bounded_forces(const std::vector<Row>& rows,
                                            std::vector<std::optional<reference::Answer>> answers) {
  std::vector<double> mesh_sizes;
  std::vector<std::vector<pfv::Vec3>> forces;
  std::optional<double> order;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (rows[i].status != Status::answered)
      continue;
    if (!answers[i] || !answers[i]->sphere_forces)
      return std::nullopt;
    mesh_sizes.push_back(rows[i].mesh_size);
    forces.push_back(std::move(*answers[i]->sphere_forces));
    order = rows[i].convergence_order;
  }
  return extrapolate_forces(mesh_sizes, forces, order);
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
  auto kept = read_answers(rows, answers);
  Finding finding{rows.front().case_id, rows.front().method, rows, {}, {}};
  std::vector<Row> answered;
  std::ranges::copy_if(rows, std::back_inserter(answered), has_answer);
  if (answered.empty())
    return finding;
  finding.permeability = bounded_permeability(answered);
  finding.forces = bounded_forces(rows, std::move(kept));
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
