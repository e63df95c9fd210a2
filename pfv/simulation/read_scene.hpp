#pragma once

#include "pfv/simulation/simulation.hpp"

#include <filesystem>

namespace pfv {

/// How long a scene runs when the command does not say.
struct Duration {
  std::optional<double> until; // s
  std::optional<std::size_t> steps;
  std::optional<double> unbalanced; // ends once dry grains are in equilibrium; the others are what it may take
};

struct SceneFile {
  Scene scene;
  Duration duration;
};

/// Reads a scene from TOML. What it does not name is absent: without [flow] or [faces] no fluid flows, without
/// [gravity] there is no weight. Throws InputError (file, line, value, what is allowed); unknown keys are errors.
SceneFile read_scene(const std::filesystem::path& file);

} // namespace pfv
