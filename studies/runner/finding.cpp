#include "studies/runner/finding.hpp"

#include "pfv/problem/text.hpp"
#include "reference/answer.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace studies {

namespace {

std::optional<BoundedForces> bounded_forces(const std::vector<Row>& answered, const std::filesystem::path& answers) {
  std::vector<double> mesh_sizes;
  std::vector<std::vector<pfv::Vec3>> forces;
  for (const Row& row : answered) {
    const auto file = answer_file(answers, row.key);
    if (!std::filesystem::exists(file))
      return std::nullopt;
    auto answer = reference::answer_from_json(pfv::read_text(file));
    if (!answer.sphere_forces)
      return std::nullopt;
    mesh_sizes.push_back(row.mesh_size);
    forces.push_back(std::move(*answer.sphere_forces));
  }
  return extrapolate_forces(mesh_sizes, forces, answered.back().convergence_order);
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
  Finding finding{rows.front().case_id, rows.front().method, rows, {}, {}};
  std::vector<Row> answered;
  std::ranges::copy_if(rows, std::back_inserter(answered), has_answer);
  if (answered.empty())
    return finding;
  finding.permeability = bounded_permeability(answered);
  finding.forces = bounded_forces(answered, answers);
  return finding;
}

std::filesystem::path answer_file(const std::filesystem::path& answers, const std::string& key) {
  return answers / (key + ".json");
}

} // namespace studies
