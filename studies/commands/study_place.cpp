#include "studies/commands/study_place.hpp"

#include "pfv/problem/error.hpp"
#include "studies/motion/experiment.hpp"
#include "studies/runner/build_paths.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace studies {

std::filesystem::path studies_folder() {
  return source_of_studies;
}

std::filesystem::path study_file(const std::string& name) {
  for (const std::filesystem::path& candidate :
       {studies_folder() / name / "study.toml", std::filesystem::path(name) / "study.toml",
        std::filesystem::path(name)})
    if (std::filesystem::is_regular_file(candidate))
      return candidate;
  throw pfv::InputError(fmt::format("unknown study '{}'; it can be one of {}, or a folder with a study.toml", name,
                                    fmt::join(all_names(), ", ")));
}

std::vector<std::string> study_names() {
  std::vector<std::string> names;
  if (std::filesystem::is_directory(studies_folder()))
    for (const auto& entry : std::filesystem::directory_iterator(studies_folder()))
      if (std::filesystem::exists(entry.path() / "study.toml"))
        names.push_back(entry.path().filename().string());
  std::ranges::sort(names);
  return names;
}

std::vector<std::string> all_names() {
  std::vector<std::string> names = study_names();
  for (const Experiment& experiment : experiments())
    names.emplace_back(experiment.name);
  std::ranges::sort(names);
  return names;
}

} // namespace studies
