#pragma once

#include "studies/runner/plan.hpp"
#include "studies/runner/row_store.hpp"

#include <filesystem>
#include <functional>
#include <string>

namespace studies {

/// The folders and files a study works in.
struct WorkFolder {
  std::filesystem::path root;

  std::filesystem::path rows() const { return root / "rows.csv"; }
  std::filesystem::path answers() const { return root / "answers"; }
  std::filesystem::path logs() const { return root / "logs"; }
  std::filesystem::path cases() const { return root / "cases"; }
  std::filesystem::path scratch() const { return root / "tmp"; }
};

/// What an onlooker is told. Never called from two threads at once.
struct Onlooker {
  std::function<void(const std::string& what)> noticed = [](const std::string&) {};
  std::function<void(const std::string& what)> preparing = [](const std::string&) {};
  std::function<void(std::size_t already_stored, std::size_t all)> planned = [](std::size_t, std::size_t) {};
  std::function<void(const PlannedRun&, double expected_cpu_seconds)> started = [](const PlannedRun&, double) {};
  std::function<void(const PlannedRun&, const Row&)> finished = [](const PlannedRun&, const Row&) {};
};

struct RunSettings {
  std::filesystem::path study_executable; // started anew for each run
  WorkFolder work;
  int jobs = 1;              // runs at the same time; more than one disturbs the timings
  bool fresh = false;        // forget everything stored in the work folder first
  bool retry_failed = false; // run again what failed before
};

/// Does what is planned and not yet stored, a row at a time: killed at any moment it goes on where it was.
/// Stored answers and failures stand; a stored answer that can no longer be read becomes a failure. That a method does
/// not cover a case, is unavailable or over budget is decided anew and stored when it has changed. Returns the rows of
/// the plan in its order. Throws pfv::InputError on a bad question, std::system_error when the work folder cannot be
/// written.
std::vector<Row> run_study(const Study& study, const Scope& scope, const RunSettings& settings,
                           const Onlooker& onlooker = {});

/// The newest stored row of each planned run that has one, in the order of the plan.
std::vector<Row> rows_of_plan(const std::vector<PlannedRun>& runs, const std::vector<Row>& stored);

} // namespace studies
