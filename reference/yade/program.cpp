#include "reference/yade/program.hpp"

#include "meshing/child_process.hpp"
#include "pfv/problem/error.hpp"
#include "pfv/problem/text.hpp"
#include "reference/on_path.hpp"
#include "reference/temporary_folder.hpp"

#include <fmt/format.h>
#include <regex>

namespace reference::yade {

namespace {

meshing::ChildResult run(const std::filesystem::path& folder, const std::vector<std::string>& arguments,
                         std::optional<double> wall_limit) {
  meshing::ChildOptions options;
  options.working_folder = folder;
  options.log = folder / "log";
  options.wall_limit = wall_limit;
  for (const char* threads : {"OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS"})
    options.environment.emplace(threads, "1");
  return meshing::run_child(arguments, options);
}

std::string ask_version() {
  if (missing_program())
    return {};
  const TemporaryFolder folder("yade");
  if (!run(folder.path(), {"yade", "--version"}, 60).succeeded())
    return "YADE of unknown version";
  const std::string text = pfv::read_text(folder.path() / "log");
  std::smatch version;
  return std::regex_search(text, version, std::regex(R"(version:\s*(\S+))")) ? "YADE " + version.str(1)
                                                                             : "YADE of unknown version";
}

} // namespace

std::optional<std::string> missing_program() {
  if (!on_path("yade"))
    return "no program yade on PATH (Debian package yade)";
  return std::nullopt;
}

std::string program_version() {
  static const std::string version = ask_version();
  return version;
}

void run_script(const std::filesystem::path& folder, const std::string& script, double wall_limit) {
  const auto result = run(folder, {"yade", "-x", "-n", "-j1", script}, wall_limit);
  if (!result.succeeded())
    throw pfv::SolveError(
        fmt::format("yade: {}; its last words: {}", result.how_it_ended(), meshing::last_lines(folder / "log")));
}

} // namespace reference::yade
