#pragma once

#include "pfv/simulation/pore_fluid.hpp"
#include "pfv/simulation/scene_keys.hpp"

#include <filesystem>
#include <optional>

namespace pfv {

/// The fluid by the tables of a scene, which the file holds; nothing without [flow] or [faces]. Its faces repeat along
/// the periodic axes of the grains. Throws InputError (file, line, value, what is allowed).
std::optional<FluidScene> read_fluid_scene(const std::filesystem::path& file, const toml::table& root,
                                           const Packing& packing, const PeriodicAxes& periodic);

} // namespace pfv
