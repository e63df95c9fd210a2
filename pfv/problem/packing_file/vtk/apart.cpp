#include "pfv/problem/packing_file/vtk/apart.hpp"

#include "pfv/problem/error.hpp"

#include <array>
#include <cerrno>
#include <fcntl.h>
#include <fstream>
#include <string_view>
#include <sys/resource.h>
#include <sys/wait.h>
#include <system_error>
#include <unistd.h>

namespace pfv {
namespace {

enum ExitCode { answered = 0, refused = 1, lost = 2 };

void write_all(int file, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = write(file, bytes.data(), bytes.size());
    if (written < 0 && errno != EINTR)
      _exit(lost);
    bytes.remove_prefix(written > 0 ? static_cast<std::size_t>(written) : 0);
  }
}

std::string read_all(int file) {
  std::string bytes;
  std::array<char, 65536> some;
  while (true) {
    const ssize_t count = read(file, some.data(), some.size());
    if (count > 0)
      bytes.append(some.data(), static_cast<std::size_t>(count));
    else if (count == 0 || errno != EINTR)
      return bytes;
  }
}

void limit_to(const Allowance& allowance) {
  std::size_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  const rlim_t memory = pages * static_cast<std::size_t>(sysconf(_SC_PAGESIZE)) + allowance.memory;
  const rlimit space{memory, memory}, time{allowance.cpu_seconds, allowance.cpu_seconds}, no_core{0, 0};
  setrlimit(RLIMIT_AS, &space);
  setrlimit(RLIMIT_CPU, &time);
  setrlimit(RLIMIT_CORE, &no_core);
}

[[noreturn]] void work_as_child(const std::function<std::string()>& work, const Allowance& allowance, int answer) {
  const int nowhere = open("/dev/null", O_WRONLY);
  dup2(nowhere, STDOUT_FILENO);
  dup2(nowhere, STDERR_FILENO);
  limit_to(allowance);
  try {
    write_all(answer, work());
    _exit(answered);
  } catch (const InputError& error) {
    write_all(answer, error.what());
    _exit(refused);
  } catch (...) {
    _exit(lost);
  }
}

int exit_code_of(pid_t child) {
  int status = 0;
  while (waitpid(child, &status, 0) < 0)
    if (errno != EINTR)
      return lost;
  return WIFEXITED(status) ? WEXITSTATUS(status) : lost;
}

} // namespace

std::optional<std::string> answer_apart(const std::function<std::string()>& work, const Allowance& allowance) {
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0)
    throw std::system_error(errno, std::generic_category(), "pipe");
  const pid_t child = fork();
  if (child < 0) {
    const int reason = errno;
    close(ends[0]);
    close(ends[1]);
    throw std::system_error(reason, std::generic_category(), "fork");
  }
  if (child == 0)
    work_as_child(work, allowance, ends[1]);
  close(ends[1]);
  std::string answer = read_all(ends[0]);
  close(ends[0]);
  const int code = exit_code_of(child);
  if (code == refused)
    throw InputError(answer);
  if (code != answered)
    return std::nullopt;
  return answer;
}

} // namespace pfv
