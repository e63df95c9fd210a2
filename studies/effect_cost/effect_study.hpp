#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace studies {

/// A scene that names one effect more than the one it is beside.
struct Effect {
  std::string id; // letters, digits, _ and -: a file name
  std::string label;
  std::string beside; // id of the effect its cost is counted from; empty for the scene of all
  std::size_t steps;  // that are measured
  std::string scene;  // TOML as read_scene reads it, without its packing

  bool operator==(const Effect&) const = default;
};

/// What each effect costs in a step: the same packing with and without it.
struct EffectStudy {
  std::string name;             // of its folder
  std::filesystem::path folder; // of its study.toml
  std::string title;
  std::string question;
  std::string preparation; // TOML of the scene that is run first; all others start from where its grains end
  std::size_t preparation_steps;
  std::size_t warm_up; // steps before those that are measured
  int repeats;         // each a process of its own, in turn with those of all other effects
  std::vector<Effect> effects;
};

/// Whether a study.toml holds effects rather than methods and cases.
bool is_effect_study(const std::filesystem::path& file);

/// Reads a study.toml with [[effect]]; the form is described in studies/README.md. `quick` takes what its [quick] says.
/// Throws pfv::InputError led by file:line, naming the valid keys or values. Scenes themselves are read later.
EffectStudy read_effect_study(const std::filesystem::path& file, bool quick);

} // namespace studies
