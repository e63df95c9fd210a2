#pragma once

#include "pfv/problem/packing.hpp"

#include <toml++/toml.h>

namespace pfv {

/// The packing made by the generator that [packing] names, with its parameters, in a box that repeats along the
/// periodic axes of the case. Throws InputError with file and line.
Packing read_generator(const toml::table& table, const PeriodicAxes& periodic);

} // namespace pfv
