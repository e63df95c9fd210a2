#pragma once

#include <array>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <sys/wait.h>
#include <unistd.h>

namespace pfv::testing {

struct ProgramResult {
  int exit_code = -1; // -1 when ended by a signal
  std::string output; // standard output
  std::string error;  // standard error
};

/// Runs a command line through the shell and collects what it prints.
inline ProgramResult run_program(const std::string& command_line) {
  const std::string error_file = "/tmp/pfv-test-error-" + std::to_string(getpid());
  FILE* pipe = popen((command_line + " 2>" + error_file).c_str(), "r");
  if (!pipe)
    throw std::runtime_error("cannot run " + command_line);
  ProgramResult result;
  std::array<char, 4096> buffer;
  while (const std::size_t count = fread(buffer.data(), 1, buffer.size(), pipe))
    result.output.append(buffer.data(), count);
  const int status = pclose(pipe);
  result.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  std::ifstream error(error_file);
  result.error.assign(std::istreambuf_iterator<char>(error), {});
  std::remove(error_file.c_str());
  return result;
}

} // namespace pfv::testing
