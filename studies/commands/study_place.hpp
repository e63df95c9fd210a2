#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace studies {

/// The folder of the studies of this source tree.
std::filesystem::path studies_folder();

/// The study.toml of a study named by its folder under studies_folder(), by any folder, or by the file itself.
/// Throws pfv::InputError naming the studies there are.
std::filesystem::path study_file(const std::string& name);

/// Names of the folders under studies_folder() that hold a study.toml, sorted.
std::vector<std::string> study_names();

/// These and the experiments, sorted.
std::vector<std::string> all_names();

} // namespace studies
