#pragma once

#include "pfv/problem/case.hpp"
#include "pfv/problem/packing_file.hpp"

#include <filesystem>
#include <optional>
#include <toml++/toml.h>

namespace pfv {

// The parts of a case file that other files have too. Each throws InputError (file, line, value, what is allowed).

/// From the table [packing]; a file in it is relative to `folder`, and `said` wins over what the table says of it.
ReadPacking read_packing(const toml::table& table, const std::filesystem::path& folder, const PeriodicAxes& periodic,
                         const PackingFileOptions& said = {});

/// [fluid], or what it is by default.
Fluid read_fluid(const toml::table& root);

/// [buoyancy], when it is there.
std::optional<Buoyancy> read_buoyancy(const toml::table& root);

} // namespace pfv
