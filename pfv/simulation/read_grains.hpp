#pragma once

#include "pfv/simulation/scene_keys.hpp"
#include "pfv/simulation/simulation.hpp"

namespace pfv {

/// Grains, their contacts, walls and what acts on them, by the tables of a scene. Throws InputError (file, line, value,
/// what is allowed).
GrainScene read_grains(const toml::table& root, const Packing& packing);

/// The axes along which there are no walls, by the table [walls]. Throws InputError likewise.
PeriodicAxes periodic_of(const toml::table& walls);

} // namespace pfv
