#include "pfv/problem/read_generator.hpp"

#include "pfv/problem/generate.hpp"
#include "pfv/problem/toml_input.hpp"

#include <fmt/format.h>

namespace pfv {

namespace {

int as_count(const toml::node& node, std::string_view name) {
  const std::int64_t count = as_integer(node, name);
  if (count < 1 || count > 1'000'000'000)
    fail_at(node, fmt::format("{} \"{}\" must be a whole number, 1 or more", name, count));
  return static_cast<int>(count);
}

/// The value of a key that may be left out.
template <typename Value, typename Read>
Value optional_value(const toml::table& table, std::string_view key, Value otherwise, Read read) {
  const toml::node* node = table.get(key);
  return node ? read(*node, key) : otherwise;
}

Packing read_lattice(const toml::table& table, Lattice lattice, const PeriodicAxes& periodic) {
  allow_keys(table, "[packing] with a lattice", {"generator", "solid_fraction", "cells", "cell_size"});
  const toml::node& fraction = required(table, "[packing]", "solid_fraction");
  const bool touching = fraction.is_string() && as_text(fraction, "solid_fraction") == "touching";
  if (!touching && !fraction.is_number())
    fail_at(fraction, fmt::format("solid_fraction \"{}\" must be a number or \"touching\"", quote(fraction)));
  const double value = touching ? touching_solid_fraction(lattice) : as_number(fraction, "solid_fraction");
  const int cells = optional_value(table, "cells", 1, as_count);
  const double cell_size = optional_value(table, "cell_size", 1.0, as_number);
  return located(table, [&] { return lattice_packing(lattice, value, cells, cell_size, periodic); });
}

Packing read_nine_spheres(const toml::table& table) {
  allow_keys(table, "[packing] with nine_spheres", {"generator", "size"});
  const double size = optional_value(table, "size", 1.0, as_number);
  return located(table, [&] { return nine_spheres(size); });
}

Packing read_random(const toml::table& table, const PeriodicAxes& periodic) {
  allow_keys(table, "[packing] with random",
             {"generator", "spheres", "solid_fraction", "radius_ratio", "seed", "size"});
  RandomPacking parameters;
  parameters.spheres = optional_value(table, "spheres", parameters.spheres, as_count);
  parameters.solid_fraction = optional_value(table, "solid_fraction", parameters.solid_fraction, as_number);
  parameters.radius_ratio = optional_value(table, "radius_ratio", parameters.radius_ratio, as_number);
  const auto seed = optional_value(table, "seed", std::int64_t{1}, as_integer);
  if (seed < 0)
    fail_at(*table.get("seed"), fmt::format("seed \"{}\" must be a whole number, 0 or more", seed));
  parameters.seed = static_cast<std::uint64_t>(seed);
  parameters.size = optional_value(table, "size", parameters.size, as_number);
  parameters.periodic = periodic;
  return located(table, [&] { return random_packing(parameters); });
}

} // namespace

Packing read_generator(const toml::table& table, const PeriodicAxes& periodic) {
  const toml::node& node = *table.get("generator");
  const std::string name = as_text(node, "generator");
  if (name == "simple_cubic")
    return read_lattice(table, Lattice::simple_cubic, periodic);
  if (name == "bcc")
    return read_lattice(table, Lattice::bcc, periodic);
  if (name == "fcc")
    return read_lattice(table, Lattice::fcc, periodic);
  if (name == "nine_spheres")
    return read_nine_spheres(table);
  if (name == "random")
    return read_random(table, periodic);
  fail_at(node, fmt::format("generator \"{}\" must be one of simple_cubic, bcc, fcc, nine_spheres, random", name));
}

} // namespace pfv
