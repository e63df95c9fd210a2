#include "meshing/child_process.hpp"

#include "meshing/child_group.hpp"

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/wait.h>

extern char** environ;

namespace meshing {

namespace {

std::vector<std::string> environment_with(const std::map<std::string, std::string>& added) {
  std::vector<std::string> result;
  for (char** entry = environ; *entry != nullptr; ++entry) {
    const std::string text = *entry;
    if (!added.contains(text.substr(0, text.find('='))))
      result.push_back(text);
  }
  for (const auto& [name, value] : added)
    result.push_back(name + "=" + value);
  return result;
}

/// Null-terminated pointers into strings that outlive them, as exec wants.
std::vector<char*> pointers(const std::vector<std::string>& strings) {
  std::vector<char*> result;
  for (const std::string& text : strings)
    result.push_back(const_cast<char*>(text.c_str()));
  result.push_back(nullptr);
  return result;
}

/// What the child does between fork and exec: only async-signal-safe calls, no allocation, as another thread of the
/// parent may have held a lock.
struct Launch {
  char* const* arguments;
  char* const* environment;
  const char* folder; // nullptr: stay
  int input, output, errors;
  pid_t parent;
  rlim_t memory; // bytes

  [[noreturn]] void run() const {
    become_child(parent, memory);
    sigset_t none;
    sigemptyset(&none);
    sigprocmask(SIG_SETMASK, &none, nullptr);
    if (dup2(input, STDIN_FILENO) >= 0 && dup2(output, STDOUT_FILENO) >= 0 && dup2(output, STDERR_FILENO) >= 0 &&
        (folder == nullptr || chdir(folder) == 0))
      execvpe(arguments[0], arguments, environment);
    const int error = errno;
    [[maybe_unused]] const auto written = write(errors, &error, sizeof error);
    _exit(127);
  }
};

} // namespace

ChildResult run_child(const std::vector<std::string>& arguments, const ChildOptions& options) {
  if (arguments.empty())
    fail(EINVAL, "no program to run");
  const std::string cannot = fmt::format("cannot run '{}'", arguments.front());
  const auto environment = environment_with(options.environment);
  const auto argument_pointers = pointers(arguments);
  const auto environment_pointers = pointers(environment);
  const std::string folder = options.working_folder.string();

  Descriptor input(open("/dev/null", O_RDONLY | O_CLOEXEC));
  Descriptor output(open_log(options));
  if (input.value() < 0 || output.value() < 0)
    fail(errno, fmt::format("{}: cannot write its log '{}'", cannot, options.log.string()));

  // Closed by a successful exec; carries errno otherwise.
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0)
    fail(errno, cannot);
  Descriptor errors_in(ends[0]);
  Descriptor errors_out(ends[1]);

  const Launch launch{argument_pointers.data(),
                      environment_pointers.data(),
                      folder.empty() ? nullptr : folder.c_str(),
                      input.value(),
                      output.value(),
                      errors_out.value(),
                      getpid(),
                      memory_of(options)};
  const auto start = Wall::now();
  const pid_t child = fork();
  if (child < 0)
    fail(errno, cannot);
  if (child == 0)
    launch.run();
  setpgid(child, child); // also here, so that the group exists whichever runs first
  errors_out.close();

  int exec_error = 0;
  ssize_t got = 0;
  while ((got = read(errors_in.value(), &exec_error, sizeof exec_error)) < 0 && errno == EINTR)
    ;
  int status = 0;
  if (got > 0) {
    waitpid(child, &status, 0);
    fail(exec_error, cannot);
  }

  return wait_for(child, start, options, cannot);
}

ChildResult run_in_child(const std::function<int()>& work, const ChildOptions& options) {
  const std::string cannot = "cannot start a process";
  Descriptor output(open_log(options));
  if (output.value() < 0)
    fail(errno, fmt::format("{}: cannot write its log '{}'", cannot, options.log.string()));
  const rlim_t memory = memory_of(options);
  const pid_t parent = getpid();
  const auto start = Wall::now();
  const pid_t child = fork();
  if (child < 0)
    fail(errno, cannot);
  if (child == 0) {
    become_child(parent, memory);
    int code = 127;
    if (dup2(output.value(), STDOUT_FILENO) >= 0 && dup2(output.value(), STDERR_FILENO) >= 0) {
      for (const auto& [name, value] : options.environment)
        setenv(name.c_str(), value.c_str(), 1);
      try {
        code = work();
      } catch (const std::exception& error) {
        [[maybe_unused]] const auto written = write(STDERR_FILENO, error.what(), std::strlen(error.what()));
        code = 1;
      }
    }
    _exit(code); // what the parent had buffered is for the parent to write
  }
  setpgid(child, child);
  return wait_for(child, start, options, cannot);
}

} // namespace meshing
