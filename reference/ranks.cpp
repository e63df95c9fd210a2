#include "reference/ranks.hpp"

#include "pfv/problem/error.hpp"
#include "reference/on_path.hpp"

#include <cstdlib>
#include <fmt/format.h>
#include <fstream>

namespace reference {

namespace {

namespace fs = std::filesystem;

// When a rank was killed mpirun says so, between other things.
std::string last_words(const fs::path& log) {
  std::ifstream in(log);
  for (std::string line; std::getline(in, line);)
    if (line.find("exited on signal") != std::string::npos)
      return line;
  return meshing::last_lines(log);
}

} // namespace

std::vector<std::string> on_ranks(int ranks, std::vector<std::string> command) {
  if (!on_path("mpirun"))
    throw pfv::SolveError(fmt::format("{} ranks need mpirun on PATH (Debian package openmpi-bin)", ranks));
  command.insert(command.begin(), {"mpirun", "--oversubscribe", "--bind-to", "none", "-n", fmt::format("{}", ranks)});
  return command;
}

void prepare_for_ranks(meshing::ChildOptions& options) {
  options.environment.insert({{"OMP_NUM_THREADS", "1"},
                              {"OPENBLAS_NUM_THREADS", "1"},
                              {"OMPI_ALLOW_RUN_AS_ROOT", "1"},
                              {"OMPI_ALLOW_RUN_AS_ROOT_CONFIRM", "1"},
                              {"OMPI_MCA_mpi_yield_when_idle", "1"}});
}

SolverProgram::SolverProgram(std::string name, std::string variable, fs::path built)
    : name_(std::move(name)), variable_(std::move(variable)), built_(std::move(built)) {}

fs::path SolverProgram::path() const {
  if (const char* chosen = std::getenv(variable_.c_str()); chosen != nullptr && *chosen != '\0')
    return chosen;
  std::error_code error;
  const fs::path self = fs::read_symlink("/proc/self/exe", error);
  const fs::path beside = self.parent_path().parent_path() / "libexec" / name_;
  return !error && fs::exists(beside) ? beside : built_;
}

meshing::ChildResult SolverProgram::run(std::vector<std::string> arguments, const fs::path& folder, int ranks,
                                        double wall_limit) const {
  meshing::ChildOptions options;
  options.working_folder = folder;
  options.log = folder / "log";
  options.wall_limit = wall_limit;
  prepare_for_ranks(options);
  arguments.insert(arguments.begin(), path().string());
  const auto result = meshing::run_child(ranks > 1 ? on_ranks(ranks, arguments) : arguments, options);
  if (!result.succeeded()) {
    // The output of several ranks ends with what MPI has to say of their end.
    const auto cause = folder / "failure.txt";
    throw pfv::SolveError(fmt::format("{}: {}; its last words: {}", name_, result.how_it_ended(),
                                      fs::exists(cause) ? meshing::last_lines(cause) : last_words(options.log)));
  }
  return result;
}

} // namespace reference
