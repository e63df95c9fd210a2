#include "meshing/child_group.hpp"

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <system_error>

namespace meshing {
namespace {

double seconds_since(Wall::time_point start) {
  return std::chrono::duration<double>(Wall::now() - start).count();
}

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

} // namespace

void fail(int error, const std::string& what) {
  throw std::system_error(error, std::generic_category(), what);
}

void become_child(pid_t parent, rlim_t memory) {
  setpgid(0, 0);
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  const rlimit data{memory, memory};
  setrlimit(RLIMIT_DATA, &data);
  if (getppid() != parent) // it died before
    _exit(127);
}

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
  // Before reaping, while the number cannot belong to another group; also for orphans left behind.
  kill(-child, SIGKILL);

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

int open_log(const ChildOptions& options) {
  const std::string log = options.log.empty() ? "/dev/null" : options.log.string();
  return open(log.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
}

} // namespace meshing
