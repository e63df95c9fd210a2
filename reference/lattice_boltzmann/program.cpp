#include "reference/lattice_boltzmann/program.hpp"

#include "pfv/problem/error.hpp"
#include "pfv/problem/text.hpp"
#include "reference/ranks.hpp"
#include "reference/temporary_folder.hpp"

#include <fmt/format.h>
#include <fstream>

namespace reference::lattice_boltzmann {

namespace {

SolverProgram lattice_flow() {
  return {"lattice_flow", "PFV_LATTICE_FLOW", LATTICE_FLOW_PATH};
}

} // namespace

std::optional<std::string> missing_program() {
  const std::filesystem::path program = lattice_flow().path();
  if (program.empty())
    return "this build has no lattice-Boltzmann solver: Palabos was not found (Debian package libplb-dev)";
  if (!std::filesystem::exists(program))
    return fmt::format("the lattice-Boltzmann solver {} does not exist", program.string());
  return std::nullopt;
}

FlowReply run_lattice_flow(const FlowQuestion& question, int ranks, double wall_limit) {
  const TemporaryFolder folder("lattice_boltzmann");
  std::ofstream(folder.path() / "question.json") << to_json(question);
  lattice_flow().run({"question.json", "reply.json"}, folder.path(), ranks, wall_limit);
  try {
    return flow_reply_from_json(pfv::read_text(folder.path() / "reply.json"));
  } catch (const std::exception& error) {
    throw pfv::SolveError(fmt::format("lattice_flow's reply cannot be read: {}", error.what()));
  }
}

} // namespace reference::lattice_boltzmann
