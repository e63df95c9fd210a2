#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

/// How a finished `study` ended and what it printed.
struct StudyOutput {
  int exit_code = -1;
  std::string out;
  std::string err;
};

/// Runs `study` with these arguments and waits. `environment` is added; an empty value takes the variable away.
StudyOutput study(const std::vector<std::string>& arguments,
                  const std::map<std::string, std::string>& environment = {});

/// A running `study`, killed at the latest when this goes.
class RunningStudy {
public:
  RunningStudy(const std::vector<std::string>& arguments, const std::map<std::string, std::string>& environment,
               const std::filesystem::path& log);
  ~RunningStudy();
  RunningStudy(const RunningStudy&) = delete;
  RunningStudy& operator=(const RunningStudy&) = delete;

  /// By SIGKILL, so that it cannot tidy up; then waits for its end.
  void kill();
  bool ended();

private:
  int pid_;
};

/// What `study` prints on a terminal of its own.
std::string study_on_terminal(const std::vector<std::string>& arguments,
                              const std::map<std::string, std::string>& environment);
