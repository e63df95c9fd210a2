#include "studies/commands/commands.hpp"
#include "studies/commands/study_place.hpp"

#include "pfv/problem/error.hpp"
#include "pfv/problem/text.hpp"
#include "studies/calibration/calibrate.hpp"
#include "studies/runner/build_info.hpp"
#include "studies/runner/case_store.hpp"
#include "studies/runner/compare.hpp"
#include "studies/runner/csv.hpp"
#include "studies/runner/files.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

namespace studies {

namespace {

constexpr double share_covered = 0.9; // of the packings, by the error that is told

/// The packings of a study with what its committed permeabilities.csv says of them.
std::vector<KnownPermeability> known_permeabilities(const std::filesystem::path& study_toml,
                                                    const std::filesystem::path& cases) {
  const Study study = read_study(study_toml);
  const auto file = study_toml.parent_path() / "results" / "permeabilities.csv";
  const auto records = parse_csv(pfv::read_text(file)).records;
  if (records.empty())
    throw pfv::InputError(fmt::format("{} is empty", file.string()));
  const auto column = [&](const char* name) {
    const auto found = std::ranges::find(records[0], name);
    if (found == records[0].end())
      throw pfv::InputError(fmt::format("{}: no column \"{}\"", file.string(), name));
    return static_cast<std::size_t>(found - records[0].begin());
  };
  const std::size_t id = column("case"), value = column("permeability_m2"), error = column("error_m2");
  std::vector<KnownPermeability> known;
  for (std::size_t n = 1; n < records.size(); ++n) {
    const auto& record = records[n];
    const auto number = [&](std::size_t field) {
      const auto read = pfv::to_number(record[field]);
      if (!read || !(*read > 0))
        throw pfv::InputError(fmt::format("{}:{}: {} \"{}\" must be a number above 0", file.string(), n + 1,
                                          records[0][field], record[field]));
      return *read;
    };
    if (record.size() != records[0].size())
      throw pfv::InputError(fmt::format("{}:{}: {} fields, the first line has {}", file.string(), n + 1, record.size(),
                                        records[0].size()));
    const auto one = std::ranges::find(study.cases, record[id], &StudyCase::id);
    if (one == study.cases.end())
      throw pfv::InputError(fmt::format("{}: {} has no case \"{}\"", file.string(), study_toml.string(), record[id]));
    known.push_back({record[id], store_case(*one, cases, digest_of_sources({"pfv/problem"})).problem, number(value),
                     number(error)});
  }
  return known;
}

/// What the share of the values does not exceed in size.
double bound(std::vector<double> values) {
  std::ranges::transform(values, values.begin(), [](double value) { return std::abs(value); });
  std::ranges::sort(values);
  return values[static_cast<std::size_t>(std::ceil(share_covered * static_cast<double>(values.size()))) - 1];
}

void calibrate_command(const std::string& name) {
  const std::filesystem::path file = study_file(name), folder = file.parent_path();
  const auto known = known_permeabilities(file, folder / "work" / "cases");
  const Calibration fit = calibrate(known);
  std::string table = to_csv({"case", "permeability_m2", "error_m2", "ln_ratio_fitted", "ln_ratio_left_out"});
  for (std::size_t n = 0; n < known.size(); ++n)
    table += to_csv({known[n].id, fmt::format("{:.6g}", known[n].permeability), fmt::format("{:.3g}", known[n].error),
                     fmt::format("{:.4f}", fit.difference[n]), fmt::format("{:.4f}", fit.left_out[n])});
  const auto to = folder / "results" / "calibration.csv";
  write_file(to, table);

  fmt::print("{:<22}  {}\n", "packings", known.size());
  std::string whole = to_csv({"quantity", "value", "standard_error"});
  const auto add = [&](const std::string& quantity, double value, std::optional<double> error = std::nullopt) {
    const std::string bar = error ? fmt::format("{:.4f}", *error) : "";
    whole += to_csv({quantity, fmt::format("{:.4f}", value), bar});
    fmt::print("{:<22}  {:.4f}{}\n", quantity, value, error ? " +- " + bar : "");
  };
  for (std::size_t c = 0; c < fitted_constants.size(); ++c)
    add(std::string(fitted_constants[c].name), fit.rule.*fitted_constants[c].value, fit.standard_error[c]);
  add("ln_ratio_rms_fitted", rms(fit.difference));
  add("ln_ratio_rms_left_out", rms(fit.left_out));
  add("ln_ratio_nine_in_ten", bound(fit.left_out));
  write_file(folder / "results" / "fit.csv", whole);
  fmt::print("By packing: {}\n", to.string());
}

} // namespace

void add_calibrate(CLI::App& app) {
  auto name = std::make_shared<std::string>("throat_data");
  CLI::App* command = app.add_subcommand(
      "calibrate", "Fits the conductance rule `calibrated` to the permeabilities of a study's results");
  command->add_option("study", *name, "Name of a study whose results have permeabilities.csv")->capture_default_str();
  command->callback([name] { calibrate_command(*name); });
}

} // namespace studies
