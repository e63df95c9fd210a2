#include "tests/studies/study_process.hpp"

#include "tests/studies/temporary_folder.hpp"

#include <cerrno>
#include <csignal>
#include <fcntl.h>
#include <pty.h>
#include <sstream>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace {

using Arguments = std::vector<std::string>;
using Environment = std::map<std::string, std::string>;

std::string text_of(const std::filesystem::path& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

void redirect(int stream, const std::filesystem::path& file) {
  const int descriptor = ::open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
  ::dup2(descriptor, stream);
}

[[noreturn]] void become_study(Arguments arguments, const Environment& environment) {
  for (const auto& [name, value] : environment)
    value.empty() ? ::unsetenv(name.c_str()) : ::setenv(name.c_str(), value.c_str(), 1);
  arguments.insert(arguments.begin(), STUDY_EXECUTABLE);
  std::vector<char*> pointers;
  for (std::string& argument : arguments)
    pointers.push_back(argument.data());
  pointers.push_back(nullptr);
  ::execv(pointers[0], pointers.data());
  ::_exit(127);
}

} // namespace

StudyOutput study(const Arguments& arguments, const Environment& environment, std::optional<std::size_t> largest_file) {
  const TemporaryFolder folder;
  const int pid = ::fork();
  if (pid == 0) {
    redirect(STDOUT_FILENO, folder.path() / "out");
    redirect(STDERR_FILENO, folder.path() / "err");
    if (largest_file) {
      const rlimit limit{*largest_file, *largest_file};
      ::setrlimit(RLIMIT_FSIZE, &limit);
      ::signal(SIGXFSZ, SIG_IGN); // for the error of the write instead
    }
    become_study(arguments, environment);
  }
  int status = 0;
  ::waitpid(pid, &status, 0);
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, text_of(folder.path() / "out"), text_of(folder.path() / "err")};
}

RunningStudy::RunningStudy(const Arguments& arguments, const Environment& environment, const std::filesystem::path& log)
    : pid_(::fork()) {
  if (pid_ == 0) {
    redirect(STDOUT_FILENO, log);
    ::dup2(STDOUT_FILENO, STDERR_FILENO);
    become_study(arguments, environment);
  }
}

RunningStudy::~RunningStudy() {
  kill();
}

void RunningStudy::kill() {
  if (pid_ < 0)
    return;
  ::kill(pid_, SIGKILL);
  ::waitpid(pid_, nullptr, 0);
  pid_ = -1;
}

bool RunningStudy::ended() {
  if (pid_ >= 0 && ::waitpid(pid_, nullptr, WNOHANG) == pid_)
    pid_ = -1;
  return pid_ < 0;
}

std::string study_on_terminal(const Arguments& arguments, const Environment& environment) {
  int terminal = -1;
  winsize size{24, 100, 0, 0};
  const int pid = ::forkpty(&terminal, nullptr, nullptr, &size);
  if (pid == 0)
    become_study(arguments, environment);
  std::string text;
  char buffer[4096];
  while (true) {
    const ssize_t count = ::read(terminal, buffer, sizeof buffer);
    if (count > 0)
      text.append(buffer, static_cast<std::size_t>(count));
    else if (count == 0 || errno != EINTR) // EIO: the other side is closed
      break;
  }
  ::close(terminal);
  ::waitpid(pid, nullptr, 0);
  return text;
}
