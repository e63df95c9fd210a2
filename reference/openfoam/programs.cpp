#include "reference/openfoam/programs.hpp"

#include "pfv/problem/error.hpp"
#include "reference/on_path.hpp"
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

constexpr std::array programs{"gmshToFoam", "renumberMesh", "simpleFoam"};

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
  const auto result = meshing::run_child(arguments, options);
  if (!result.succeeded())
    throw pfv::SolveError(
        fmt::format("{}: {}; its last words: {}", arguments.front(), result.how_it_ended(), last_words(options.log)));
  return result;
}

} // namespace reference::openfoam
