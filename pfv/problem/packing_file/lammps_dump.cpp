#include "pfv/problem/packing_file/formats.hpp"
#include "pfv/problem/packing_file/sphere_table.hpp"
#include "pfv/problem/text.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace pfv {
namespace {

/// Which columns hold a sphere; a scaled position is a share of the box.
struct DumpColumns {
  SphereColumns columns;
  std::array<bool, 3> scaled{};
};

/// Columns by the names that LAMMPS gives them: x, xu (unwrapped), xs (scaled), xsu (both).
std::optional<DumpColumns> dump_columns(const Fields& names) {
  const auto column = [&](std::string_view name) -> std::optional<std::size_t> {
    const auto found = std::ranges::find(names, name);
    return found == names.end() ? std::nullopt : std::optional<std::size_t>(found - names.begin());
  };
  DumpColumns found;
  for (int axis = 0; axis < 3; ++axis) {
    bool there = false;
    for (const char* kind : {"", "u", "s", "su"})
      if (const auto position = column(std::string(axis_names[axis]) + kind); position && !there) {
        there = true;
        found.columns.centre[axis] = *position;
        found.scaled[axis] = kind[0] == 's';
      }
    if (!there)
      return std::nullopt;
  }
  for (const SizeName& size : size_names)
    if (const auto position = column(size.name)) {
      found.columns.size = *position;
      found.columns.size_name = size;
      return found;
    }
  return std::nullopt;
}

double wrapped(double at, double lower, double upper) {
  const double length = upper - lower;
  return std::clamp(at - length * std::floor((at - lower) / length), lower, upper);
}

class DumpReader {
public:
  DumpReader(const std::string& file, std::string_view contents) : lines_(file, contents) {}

  SphereList read() && {
    while (lines_.next())
      if (!split_at_blanks(lines_.line()).empty())
        read_section();
    if (!complete_)
      lines_.fail(fmt::format("the dump ends within a snapshot, before its ITEM: ATOMS"));
    if (snapshots_ > 1)
      list_.notes.push_back(
          fmt::format("{}: the last of {} snapshots, time step {}", lines_.file(), snapshots_, time_step_));
    return std::move(list_);
  }

private:
  void read_section() {
    const std::string_view title = lines_.line();
    if (title.starts_with("ITEM: TIMESTEP"))
      start_snapshot();
    else if (title.starts_with("ITEM: TIME") || title.starts_with("ITEM: UNITS"))
      line_of("a value");
    else if (title.starts_with("ITEM: NUMBER OF ATOMS"))
      atoms_ = lines_.count("number of atoms", fmt::format("{}", fmt::join(line_of("the number of atoms"), " ")));
    else if (title.starts_with("ITEM: BOX BOUNDS"))
      read_bounds(split_at_blanks(title.substr(std::string_view("ITEM: BOX BOUNDS").size())));
    else if (title.starts_with("ITEM: ATOMS"))
      read_atoms(split_at_blanks(title.substr(std::string_view("ITEM: ATOMS").size())));
    else
      lines_.fail(fmt::format("\"{}\" must be ITEM: and TIMESTEP, NUMBER OF ATOMS, BOX BOUNDS, ATOMS, UNITS or TIME",
                              shortened(title)));
  }

  /// The fields of the next line.
  Fields line_of(std::string_view what) {
    if (!lines_.next())
      lines_.fail(fmt::format("the dump ends before {}", what));
    return split_at_blanks(lines_.line());
  }

  void start_snapshot() {
    time_step_ = fmt::format("{}", fmt::join(line_of("the time step"), " "));
    atoms_.reset();
    list_ = {};
    list_.origin.file = lines_.file();
    complete_ = false;
    ++snapshots_;
  }

  void read_bounds(const Fields& flags) {
    if (flags.size() > 3 || std::ranges::any_of(flags, [](std::string_view flag) { return flag.size() != 2; }))
      lines_.fail(fmt::format("box \"{}\" must be orthogonal, as three pairs of p, f, s and m (pp ff ff) say",
                              shortened(fmt::format("{}", fmt::join(flags, " ")))));
    list_.origin.box = fmt::format("{}:{}", lines_.file(), lines_.number());
    if (flags.size() == 3)
      list_.periodic = PeriodicAxes{flags[0] == "pp", flags[1] == "pp", flags[2] == "pp"};
    list_.box.emplace();
    for (int axis = 0; axis < 3; ++axis) {
      const Fields bounds = line_of("the three bounds of its box");
      if (bounds.size() != 2)
        lines_.fail(fmt::format("bounds \"{}\" must be two numbers, lower and upper",
                                shortened(fmt::format("{}", fmt::join(bounds, " ")))));
      list_.box->lower[axis] = lines_.length("lower bound", bounds[0]);
      list_.box->upper[axis] = lines_.length("upper bound", bounds[1]);
    }
  }

  void read_atoms(const Fields& names) {
    if (!atoms_ || !list_.box)
      lines_.fail("ITEM: ATOMS must follow ITEM: NUMBER OF ATOMS and ITEM: BOX BOUNDS");
    const auto columns = dump_columns(names);
    if (!columns)
      lines_.fail(fmt::format("columns \"{}\" must have x, y, z (or xu, xs, xsu ...) and radius or diameter",
                              shortened(fmt::format("{}", fmt::join(names, " ")))));
    for (std::size_t i = 0; i < *atoms_; ++i) {
      const Fields fields = line_of(fmt::format("{} atoms, after {}", *atoms_, i));
      if (fields.size() != names.size())
        lines_.fail(fmt::format("\"{}\" has {} columns and must have {}, as ITEM: ATOMS says",
                                shortened(fmt::format("{}", fmt::join(fields, " "))), fields.size(), names.size()));
      list_.spheres.push_back(in_box(sphere_in(fields, columns->columns, lines_), columns->scaled));
      list_.origin.sphere_lines.push_back(lines_.number());
    }
    complete_ = true;
  }

  /// With its centre in the unit of the box and, along periodic axes, in the box: between two lists of neighbours
  /// LAMMPS lets atoms leave it.
  Sphere in_box(Sphere sphere, const std::array<bool, 3>& scaled) const {
    const auto& [lower, upper] = *list_.box;
    for (int axis = 0; axis < 3; ++axis) {
      double& at = sphere.centre[axis];
      if (scaled[axis])
        at = std::lerp(lower[axis], upper[axis], at);
      if (list_.periodic && (*list_.periodic)[axis] && lower[axis] < upper[axis] && std::isfinite(at))
        at = wrapped(at, lower[axis], upper[axis]);
    }
    return sphere;
  }

  TextLines lines_;
  SphereList list_; // of the snapshot that is read
  std::optional<std::size_t> atoms_;
  std::string time_step_;
  std::size_t snapshots_ = 0;
  bool complete_ = false;
};

} // namespace

SphereList read_lammps_dump(const std::string& file, std::string_view contents) {
  return DumpReader(file, contents).read();
}

} // namespace pfv
