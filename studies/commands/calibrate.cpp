#include "studies/commands/commands.hpp"
#include "studies/commands/study_place.hpp"

#include "studies/calibration/calibrate.hpp"
#include "studies/calibration/spread_fit.hpp"
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

/// What the share of the values does not exceed in size.
double bound(std::vector<double> values) {
  std::ranges::transform(values, values.begin(), [](double value) { return std::abs(value); });
  std::ranges::sort(values);
  return values[static_cast<std::size_t>(std::ceil(share_covered * static_cast<double>(values.size()))) - 1];
}

void calibrate_command(const std::string& name) {
  const std::filesystem::path file = study_file(name), folder = file.parent_path();
  const auto known = known_flows(file, folder / "work" / "cases");
  const Calibration fit = calibrate(known);
  const SpreadFit spread = fit_shear_spread(known, fit.rule);
  std::string table = to_csv({"case", "permeability_m2", "error_m2", "ln_ratio_fitted", "ln_ratio_left_out",
                              "force_rms_by_throat", "force_rms_fitted", "force_rms_left_out"});
  for (std::size_t n = 0; n < known.size(); ++n)
    table += to_csv({known[n].id, fmt::format("{:.6g}", known[n].permeability), fmt::format("{:.3g}", known[n].error),
                     fmt::format("{:.4f}", fit.difference[n]), fmt::format("{:.4f}", fit.left_out[n]),
                     fmt::format("{:.4f}", spread.by_throat[n]), fmt::format("{:.4f}", spread.fitted[n]),
                     fmt::format("{:.4f}", spread.left_out[n])});
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
  add("shear_spread", spread.share, spread.standard_error);
  add("ln_ratio_rms_fitted", rms(fit.difference));
  add("ln_ratio_rms_left_out", rms(fit.left_out));
  add("ln_ratio_nine_in_ten", bound(fit.left_out));
  add("force_rms_by_throat", rms(spread.by_throat));
  add("force_rms_fitted", rms(spread.fitted));
  add("force_rms_left_out", rms(spread.left_out));
  add("force_nine_in_ten", bound(spread.left_out));
  write_file(folder / "results" / "fit.csv", whole);
  fmt::print("By packing: {}\n", to.string());
}

} // namespace

void add_calibrate(CLI::App& app) {
  auto name = std::make_shared<std::string>("throat_data");
  CLI::App* command = app.add_subcommand(
      "calibrate", "Fits the rule `calibrated` to the permeabilities and forces of a study's results");
  command->add_option("study", *name, "Name of a study whose results have permeabilities.csv and forces.csv")
      ->capture_default_str();
  command->callback([name] { calibrate_command(*name); });
}

} // namespace studies
