#include "studies/calibration/known_flow.hpp"

#include "pfv/problem/error.hpp"
#include "pfv/problem/text.hpp"
#include "studies/runner/build_info.hpp"
#include "studies/runner/case_store.hpp"
#include "studies/runner/csv.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace studies {

namespace {

/// A CSV file whose first line names its columns.
class Table {
public:
  explicit Table(std::filesystem::path file)
      : file_(std::move(file)), records_(parse_csv(pfv::read_text(file_)).records) {
    if (records_.empty())
      throw pfv::InputError(fmt::format("{} is empty", file_.string()));
    for (std::size_t n = 1; n < records_.size(); ++n)
      if (records_[n].size() != records_[0].size())
        throw pfv::InputError(fmt::format("{}:{}: {} fields, the first line has {}", file_.string(), n + 1,
                                          records_[n].size(), records_[0].size()));
  }

  std::size_t lines() const { return records_.size(); }

  const std::string& text(std::size_t line, std::string_view column) const {
    const auto found = std::ranges::find(records_[0], column);
    if (found == records_[0].end())
      throw pfv::InputError(fmt::format("{}: no column \"{}\"", file_.string(), column));
    return records_[line][static_cast<std::size_t>(found - records_[0].begin())];
  }

  double number(std::size_t line, std::string_view column) const {
    const std::string& field = text(line, column);
    if (const auto read = pfv::to_number(field))
      return *read;
    throw pfv::InputError(fmt::format("{} \"{}\" must be a number", place(line, column), field));
  }

  double positive(std::size_t line, std::string_view column) const {
    const double read = number(line, column);
    if (!(read > 0))
      throw pfv::InputError(fmt::format("{} \"{}\" must be above 0", place(line, column), text(line, column)));
    return read;
  }

private:
  std::string place(std::size_t line, std::string_view column) const {
    return fmt::format("{}:{}: {}", file_.string(), line + 1, column);
  }

  std::filesystem::path file_;
  std::vector<CsvRecord> records_;
};

} // namespace

std::vector<KnownFlow> known_flows(const std::filesystem::path& study_toml, const std::filesystem::path& cases) {
  const Study study = read_study(study_toml);
  const auto results = study_toml.parent_path() / "results";
  const Table permeabilities(results / "permeabilities.csv"), forces(results / "forces.csv");
  std::vector<KnownFlow> known;
  for (std::size_t n = 1; n < permeabilities.lines(); ++n) {
    const std::string& id = permeabilities.text(n, "case");
    const auto one = std::ranges::find(study.cases, id, &StudyCase::id);
    if (one == study.cases.end())
      throw pfv::InputError(fmt::format("{}: no case \"{}\", of which the results tell", study_toml.string(), id));
    known.push_back({.id = id,
                     .problem = store_case(*one, cases, digest_of_sources({"pfv/problem"})).problem,
                     .permeability = permeabilities.positive(n, "permeability_m2"),
                     .error = permeabilities.positive(n, "error_m2"),
                     .force = {}});
  }
  for (std::size_t n = 1; n < forces.lines(); ++n)
    if (const auto of = std::ranges::find(known, forces.text(n, "case"), &KnownFlow::id); of != known.end())
      of->force.emplace_back(forces.number(n, "force_x_N"), forces.number(n, "force_y_N"),
                             forces.number(n, "force_z_N"));
  for (const auto& of : known)
    if (of.force.size() != of.problem.packing.spheres.size())
      throw pfv::InputError(fmt::format("{}: {} forces on the {} spheres of {}", (results / "forces.csv").string(),
                                        of.force.size(), of.problem.packing.spheres.size(), of.id));
  return known;
}

} // namespace studies
