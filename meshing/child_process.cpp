#include "meshing/child_process.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstring>
#include <deque>
#include <fcntl.h>
#include <fmt/format.h>
#include <fstream>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <system_error>
#include <unistd.h>

extern char** environ;

namespace meshing {

namespace {

using Wall = std::chrono::steady_clock;

double seconds_since(Wall::time_point start) {
  return std::chrono::duration<double>(Wall::now() - start).count();
}

class Descriptor {
public:
  explicit Descriptor(int value) : value_(value) {}
  ~Descriptor() { close(); }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  int value() const { return value_; }
  void close() {
    if (value_ >= 0)
      ::close(value_);
    value_ = -1;
  }

private:
  int value_;
};

[[noreturn]] void fail(int error, const std::string& what) {
  throw std::system_error(error, std::generic_category(), what);
}

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

/// A group of its own that dies with the parent.
void become_child(pid_t parent, rlim_t memory) {
  setpgid(0, 0);
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  const rlimit data{memory, memory};
  setrlimit(RLIMIT_DATA, &data);
  if (getppid() != parent) // it died before
    _exit(127);
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

/// Waits until the process has ended, without reaping it; false when `wall_limit` (s) passed first.
bool wait_until_ended(int pidfd, const std::optional<double>& wall_limit) {
  const auto start = Wall::now();
  while (true) {
    int timeout = -1; // ms
    if (wall_limit) {
      const double left = *wall_limit - seconds_since(start);
      if (left <= 0)
        return false;
      timeout = static_cast<int>(std::min(left * 1e3 + 1, 1e9));
    }
    pollfd waiting{pidfd, POLLIN, 0};
    const int ready = poll(&waiting, 1, timeout);
    if (ready > 0 || (ready < 0 && errno != EINTR)) // wait4 blocks in the second case
      return true;
  }
}

double seconds(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

/// Waits for the leader of a process group, ends what is left of the group and tells how it went.
ChildResult wait_for(pid_t child, Wall::time_point start, const ChildOptions& options, const std::string& cannot) {
  int status = 0;
  ChildResult result;
  Descriptor pidfd(static_cast<int>(syscall(SYS_pidfd_open, child, 0)));
  if (pidfd.value() < 0) {
    const int error = errno;
    kill(-child, SIGKILL);
    waitpid(child, &status, 0);
    fail(error, cannot);
  }
  const bool ended = wait_until_ended(pidfd.value(), options.wall_limit);
  kill(-child,
       SIGKILL); // before reaping, while the number cannot belong to another group; also for orphans left behind

  rusage usage{};
  while (wait4(child, &status, 0, &usage) < 0)
    if (errno != EINTR)
      fail(errno, cannot);
  if (WIFEXITED(status))
    result.exit_code = WEXITSTATUS(status);
  else
    result.signal = WTERMSIG(status);
  result.timed_out = !ended && result.signal == SIGKILL;
  result.cpu_seconds = seconds(usage.ru_utime) + seconds(usage.ru_stime);
  result.peak_memory_bytes = static_cast<std::size_t>(usage.ru_maxrss) * 1024;
  result.wall_seconds = seconds_since(start);
  return result;
}

rlim_t memory_of(const ChildOptions& options) {
  rlimit own{};
  getrlimit(RLIMIT_DATA, &own);
  return std::min(own.rlim_max, options.memory_limit.value_or(own.rlim_cur));
}

/// Where a child's output goes.
int open_log(const ChildOptions& options) {
  const std::string log = options.log.empty() ? "/dev/null" : options.log.string();
  return open(log.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
}

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

std::string ChildResult::how_it_ended() const {
  if (timed_out)
    return fmt::format("stopped after {:g} s", std::round(wall_seconds * 10) / 10);
  if (signal != 0)
    return fmt::format("killed by signal {} ({})", signal, sigdescr_np(signal));
  return fmt::format("exit code {}", exit_code);
}

std::string last_lines(const std::filesystem::path& log, std::size_t lines) {
  std::ifstream in(log);
  std::deque<std::string> last;
  for (std::string line; std::getline(in, line);) {
    while (!line.empty() && std::isspace(static_cast<unsigned char>(line.back())))
      line.pop_back();
    if (line.empty())
      continue;
    last.push_back(line);
    if (last.size() > lines)
      last.pop_front();
  }
  std::string joined;
  for (const std::string& line : last)
    joined += (joined.empty() ? "" : " | ") + line;
  return joined;
}

} // namespace meshing
