#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace meshing {

struct ChildOptions {
  std::filesystem::path working_folder{};           // the parent's when empty
  std::filesystem::path log{};                      // standard output and error, discarded when empty
  std::map<std::string, std::string> environment{}; // added to the parent's
  std::optional<double> wall_limit{};               // s; the child and its children are killed past it
  std::optional<std::size_t> memory_limit{};        // bytes of each of them; what they ask for past it they do not get
};

struct ChildResult {
  int exit_code = -1; // -1 when ended by a signal
  int signal = 0;     // 0 when it exited by itself
  bool timed_out = false;
  double wall_seconds = 0;
  double cpu_seconds = 0;            // user + system, of the child and the children it waited for
  std::size_t peak_memory_bytes = 0; // largest of the child and those; never below what this process held at the start
  bool succeeded() const { return exit_code == 0 && signal == 0; }
  /// "exit code 3", "killed by signal 11 (Segmentation fault)", "stopped after 60 s".
  std::string how_it_ended() const;
};

/// Runs a program without a shell, found by PATH, with no input, in its own process group, and waits for it (wait4).
/// What is left of the group is killed when it ends, and the program when the calling thread dies. Throws
/// std::system_error when it cannot be started.
ChildResult run_child(const std::vector<std::string>& arguments, const ChildOptions& options = {});

/// The same with a function of this program instead of another one, for what may crash: the child is a copy of this
/// process, ends with what the function returns, and leaves its results in files. An exception is exit code 1, its text
/// the end of the log. The working folder is this one's. Only for a process that has no other threads.
ChildResult run_in_child(const std::function<int()>& work, const ChildOptions& options = {});

/// The last lines of a log, on one line, for a message.
std::string last_lines(const std::filesystem::path& log, std::size_t lines = 3);

} // namespace meshing
