#pragma once

#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace studies {

/// A number that a hard case is held by.
struct Measure {
  static constexpr double none = std::numeric_limits<double>::infinity();

  std::string what; // with its unit
  double value = 0;
  double least = -none, most = none;

  bool holds() const { return value >= least && value <= most; } // what is no number does not
};

/// What became of a case that was answered.
struct Measured {
  std::vector<Measure> measures;
  std::string remarks = {}; // remedies that were taken, words of a refusal
  std::vector<double> plotted = {};
};

/// What the original implementation did with it.
struct Theirs {
  std::string words;
  std::vector<double> plotted = {};
};

/// A hard case.
struct Trial {
  std::string group; // a table of the report
  std::string name;
  bool quick = false;
  std::function<Measured()> ours;
  std::function<Theirs()> theirs = {}; // nothing when there is nothing to ask
};

/// A case and how it ended.
struct TrialRow {
  std::string group, name;
  std::string outcome; // "done", "killed by signal 11 (Segmentation fault)", "exit code 1: ..."
  Measured ours;
  std::optional<Theirs> theirs;
  double cpu_seconds = 0; // of ours

  bool holds() const;
};

/// Outcome of a case that gave its measures.
inline constexpr const char* done = "done";

/// Runs our part in a process of its own, so that a crash or a run without end becomes a row, and then theirs.
TrialRow tried(const Trial& trial, double wall_limit = 600);

} // namespace studies
