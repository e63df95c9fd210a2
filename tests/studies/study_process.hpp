#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

/// How a finished `study` ended and what it printed.
struct StudyOutput {
  int exit_code = -1;
  std::string out;
  std::string err;
};

/// Runs `study` with these arguments and waits. `environment` is added; an empty value takes the variable away. No file
/// written by it or its children can grow beyond `largest_file` bytes: as on a full disk, writing fails there.
StudyOutput study(const std::vector<std::string>& arguments, const std::map<std::string, std::string>& environment = {},
                  std::optional<std::size_t> largest_file = std::nullopt);

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
