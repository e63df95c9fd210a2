#pragma once

#include "pfv/clock.hpp"
#include "studies/document/table.hpp"

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
  std::string page; // Markdown
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
  ExperimentReport (*run)(bool quick, const Say& say);
};

/// All there are, by name.
std::span<const Experiment> experiments();

/// Nothing when no experiment has that name.
const Experiment* experiment_named(std::string_view name);

/// Writes the page and its files into the folder and draws every .gp file among them with gnuplot, when there is one.
void write_report(const ExperimentReport& report, const std::filesystem::path& folder);

/// A gnuplot script for figure.svg, `plots` beside one another: what these commands draw from the CSV files beside it.
std::string figure_script(int width, int height, int plots, std::string_view commands);

/// CPU seconds by stage and per step; what the experiment was built from and run on.
Table cost_table(std::span<const pfv::Stage> stages, std::size_t steps);
Table build_table();

} // namespace studies
