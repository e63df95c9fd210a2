#pragma once

#include "pfv/simulation/scene_keys.hpp"
#include "pfv/simulation/simulation.hpp"

namespace pfv {

/// Grains, their contacts, walls and what acts on them, by the tables of a scene. Throws InputError (file, line, value,
/// what is allowed).
GrainScene read_grains(const toml::table& root, const Packing& packing);

/// Of [walls].
PeriodicAxes periodic_of(const toml::table& walls);

} // namespace pfv
