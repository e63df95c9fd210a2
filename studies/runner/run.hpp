#pragma once

#include "studies/runner/row.hpp"
#include "studies/runner/study_file.hpp"

#include <filesystem>
#include <string>

namespace studies {

/// Exit codes of `study answer`, how a run's process tells its parent what became of it.
enum AnswerExit { exit_answered = 0, exit_input = 2, exit_solve_error = 3 };

/// One question to one method, to be answered by a process of its own.
struct RunOrder {
  std::filesystem::path study_executable;
  std::filesystem::path case_file;
  std::string method;
  double mesh_size = 1;
  int ranks = 1;
  bool samples = false;              // see Study
  double wall_limit = 1800;          // s, of each process
  double memory_limit = 8e9;         // bytes, of each process
  std::filesystem::path answer_file; // where the kept answer goes
  std::filesystem::path log;         // what the processes print
  std::filesystem::path scratch;     // their temporary folder ($TMPDIR), empty before each and gone after the last
};

/// A run shorter than `enough_seconds` of wall time is repeated, each time in a fresh process, until it took that long
/// or `enough_repeats` are done; the one with the median CPU seconds is kept, its answer too.
struct Repetition {
  int enough_repeats = 5;
  double enough_seconds = 3;
};

/// What came of it: status, message, answer's scalars and cost. Identity and provenance are for the caller to fill in.
/// A process that does not answer, cannot be started or whose answer cannot be kept gives a failed row.
Row run(const RunOrder& order, const Repetition& repetition = {});

} // namespace studies
