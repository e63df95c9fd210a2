#pragma once

#include "pfv/clock.hpp"
#include "studies/document/document.hpp"

#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace studies {

/// What an experiment hands back: a page and the files it shows or was made from.
struct ExperimentReport {
  struct File {
    std::string name; // beside the page
    std::string text;
  };
  Document page;
  std::vector<File> files;
  std::string summary; // for the terminal
  bool holds = true;   // whether what the experiment is to show came out
};

/// Tells what is being done and how much of it is done, 0 ... 1.
using Say = std::function<void(const std::string&, double)>;

/// A study of grains in motion: not several methods that answer one question, as those with a study.toml, but one
/// simulation held against a law.
struct Experiment {
  std::string_view name; // of its folder
  std::string_view title;
  std::string_view question;
  ExperimentReport (*run)(bool quick, const Say& say);
};

/// All there are, by name.
std::span<const Experiment> experiments();

/// Nothing when no experiment has that name.
const Experiment* experiment_named(std::string_view name);

/// What an experiment is to show, and whether it came out.
struct Expectation {
  std::string what;  // "largest error of the settlement"
  std::string found; // "1.2 %"
  std::string bound; // "within 3 %"
  bool holds;
};

/// An expectation that a value, of either sign, is no larger than this, told in percent.
Expectation within(std::string what, double value, double bound);

bool all_hold(std::span<const Expectation> expectations);

/// The head of an experiment's page: its question, the outcome in a sentence, and one for each expectation.
Document page_of(const Experiment& experiment, std::span<const Expectation> expectations);

/// Writes report.md, report.html and the files into the folder and draws every .gp file among them with gnuplot, when
/// there is one. Returns the path of report.html.
std::filesystem::path write_report(const ExperimentReport& report, const std::filesystem::path& folder,
                                   const std::filesystem::path& readme);

/// A gnuplot script for figure.svg, `plots` beside one another: what these commands draw from the CSV files beside it.
std::string figure_script(int width, int height, int plots, std::string_view commands);

/// CPU seconds by stage and per step; what the experiment was built from and run on.
Table cost_table(std::span<const pfv::Stage> stages, std::size_t steps);
Table build_table();

} // namespace studies
