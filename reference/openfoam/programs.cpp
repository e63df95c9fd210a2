#include "reference/openfoam/programs.hpp"

#include "pfv/problem/error.hpp"
#include "reference/on_path.hpp"
#include "reference/ranks.hpp"
#include "reference/temporary_folder.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <fmt/format.h>
#include <fstream>
#include <iterator>
#include <regex>

namespace reference::openfoam {

namespace {

constexpr std::array programs{"gmshToFoam", "renumberMesh", "simpleFoam", "decomposePar", "reconstructPar"};

std::filesystem::path project_folder() {
  const char* chosen = std::getenv("WM_PROJECT_DIR");
  return chosen && *chosen ? chosen : "/usr/share/openfoam";
}

meshing::ChildOptions options_in(const std::filesystem::path& folder, const std::string& program) {
  meshing::ChildOptions options;
  options.working_folder = folder;
  options.log = folder / ("log." + program);
  options.environment = {{"WM_PROJECT_DIR", project_folder().string()}, {"PWD", folder.string()}};
  return options;
}

// The end of a log, without the call stack that a program which diverged prints last.
std::string last_words(const std::filesystem::path& log) {
  std::ifstream in(log);
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);)
    if (!line.empty() && line.front() != '#')
      lines.push_back(line);
  std::string words;
  for (std::size_t k = lines.size() - std::min<std::size_t>(lines.size(), 4); k < lines.size(); ++k)
    words += (words.empty() ? "" : " | ") + lines[k];
  return words;
}

std::string ask_version() {
  if (missing_programs())
    return {};
  const TemporaryFolder folder("openfoam");
  const auto options = options_in(folder.path(), "simpleFoam");
  meshing::run_child({"simpleFoam", "-help"}, options);
  std::ifstream in(options.log);
  const std::string help{std::istreambuf_iterator<char>(in), {}};
  std::smatch release, patch;
  if (!std::regex_search(help, release, std::regex(R"(Using:\s+OpenFOAM-?\s*\(?([\w.]+))")))
    return "OpenFOAM of unknown version";
  if (!std::regex_search(help, patch, std::regex(R"(patch=(\w+))")))
    return fmt::format("OpenFOAM {}", release.str(1));
  return fmt::format("OpenFOAM {} (patch {})", release.str(1), patch.str(1));
}

// What ended a program, with the cause when it is that its folder can take no more.
std::string cause(const std::string& program, const meshing::ChildResult& result,
                  const meshing::ChildOptions& options) {
  constexpr std::uintmax_t next_to_nothing = 1 << 16;
  std::error_code error;
  const auto space = std::filesystem::space(options.working_folder, error);
  const char* full = !error && space.available < next_to_nothing ? " (the disk is full)" : "";
  return fmt::format("{}: {}{}; its last words: {}", program, result.how_it_ended(), full, last_words(options.log));
}

meshing::ChildResult checked(const std::string& program, const std::vector<std::string>& arguments,
                             const meshing::ChildOptions& options) {
  const auto result = meshing::run_child(arguments, options);
  if (!result.succeeded())
    throw pfv::SolveError(cause(program, result, options));
  return result;
}

} // namespace

std::optional<std::string> missing_programs() {
  for (const char* program : programs)
    if (!on_path(program))
      return fmt::format("no program {} on PATH (Debian package openfoam)", program);
  const auto settings = project_folder() / "etc" / "controlDict";
  if (!std::filesystem::exists(settings))
    return fmt::format("no {} (Debian package openfoam, or set WM_PROJECT_DIR)", settings.string());
  return std::nullopt;
}

std::string program_version() {
  static const std::string version = ask_version();
  return version;
}

meshing::ChildResult run_program(const std::filesystem::path& folder, const std::vector<std::string>& arguments,
                                 std::optional<double> wall_limit) {
  auto options = options_in(folder, arguments.front());
  options.wall_limit = wall_limit;
  return checked(arguments.front(), arguments, options);
}

meshing::ChildResult run_on_ranks(const std::filesystem::path& folder, const std::string& program, int ranks) {
  auto options = options_in(folder, program);
  prepare_for_ranks(options);
  return checked(program, on_ranks(ranks, {program, "-parallel"}), options);
}

} // namespace reference::openfoam
