#include "reference/lattice_boltzmann/program.hpp"

#include "meshing/child_process.hpp"
#include "pfv/problem/error.hpp"
#include "pfv/problem/text.hpp"
#include "reference/on_path.hpp"
#include "reference/temporary_folder.hpp"

#include <cstdlib>
#include <fmt/format.h>
#include <fstream>

namespace reference::lattice_boltzmann {

namespace {

namespace fs = std::filesystem;

fs::path find_program() {
  if (const char* chosen = std::getenv("PFV_LATTICE_FLOW"); chosen != nullptr && *chosen != '\0')
    return chosen;
  std::error_code error;
  const fs::path self = fs::read_symlink("/proc/self/exe", error);
  const fs::path beside = self.parent_path().parent_path() / "libexec" / "lattice_flow";
  return !error && fs::exists(beside) ? beside : fs::path(LATTICE_FLOW_PATH);
}

std::vector<std::string> command(const fs::path& program, int ranks) {
  std::vector<std::string> words;
  if (ranks > 1)
    words = {"mpirun", "--oversubscribe", "-n", fmt::format("{}", ranks)};
  words.insert(words.end(), {program.string(), "question.json", "reply.json"});
  return words;
}

} // namespace

std::optional<std::string> missing_program() {
  const fs::path program = find_program();
  if (program.empty())
    return "this build has no lattice-Boltzmann solver: Palabos was not found (Debian package libplb-dev)";
  if (!fs::exists(program))
    return fmt::format("the lattice-Boltzmann solver {} does not exist", program.string());
  return std::nullopt;
}

FlowReply run_lattice_flow(const FlowQuestion& question, int ranks, double wall_limit) {
  if (ranks > 1 && !on_path("mpirun"))
    throw pfv::SolveError("no program mpirun on PATH, which shares the work between ranks");
  const TemporaryFolder folder("lattice_boltzmann");
  std::ofstream(folder.path() / "question.json") << to_json(question);
  meshing::ChildOptions options;
  options.working_folder = folder.path();
  options.log = folder.path() / "log";
  options.wall_limit = wall_limit;
  options.environment = {
      {"OMP_NUM_THREADS", "1"}, {"OMPI_ALLOW_RUN_AS_ROOT", "1"}, {"OMPI_ALLOW_RUN_AS_ROOT_CONFIRM", "1"}};
  const auto result = meshing::run_child(command(find_program(), ranks), options);
  if (!result.succeeded()) {
    // The log of several processes ends with what MPI has to say of their end.
    const auto cause = folder.path() / "failure.txt";
    throw pfv::SolveError(fmt::format("lattice_flow: {}; its last words: {}", result.how_it_ended(),
                                      meshing::last_lines(fs::exists(cause) ? cause : options.log)));
  }
  try {
    return flow_reply_from_json(pfv::read_text(folder.path() / "reply.json"));
  } catch (const std::exception& error) {
    throw pfv::SolveError(fmt::format("lattice_flow's reply cannot be read: {}", error.what()));
  }
}

} // namespace reference::lattice_boltzmann
