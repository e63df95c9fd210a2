#include "pfv/problem/packing_file/sphere_table.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace pfv {
namespace {

constexpr std::array<std::string_view, 3> coordinates{"x", "y", "z"};

std::optional<std::size_t> only_column(const Fields& names, std::string_view name) {
  if (std::ranges::count(names, name) != 1)
    return std::nullopt;
  return std::ranges::find(names, name) - names.begin();
}

} // namespace

Sphere sphere_in(const Fields& fields, const SphereColumns& columns, const TextLines& lines) {
  Sphere sphere;
  for (int axis = 0; axis < 3; ++axis)
    sphere.centre[axis] = lines.length(coordinates[axis], fields[columns.centre[axis]]);
  const auto& [name, radius] = columns.size_name;
  sphere.radius = radius * lines.length(name, fields[columns.size]);
  return sphere;
}

std::optional<SphereColumns> columns_named(const Fields& names) {
  SphereColumns columns;
  for (int axis = 0; axis < 3; ++axis) {
    const auto column = only_column(names, coordinates[axis]);
    if (!column)
      return std::nullopt;
    columns.centre[axis] = *column;
  }
  int sizes = 0;
  for (const SizeName& size : size_names)
    if (const auto column = only_column(names, size.name)) {
      columns.size = *column;
      columns.size_name = size;
      ++sizes;
    }
  return sizes == 1 ? std::optional(columns) : std::nullopt;
}

std::string_view SphereTable::without_comment(const TextLines& lines) {
  const std::string_view line = lines.line();
  const auto comment = std::min(line.find('#'), line.size());
  if (comment < line.size())
    take_box(line.substr(comment + 1), lines);
  return line.substr(0, comment);
}

void SphereTable::take_box(std::string_view comment, const TextLines& lines) {
  const Fields fields = split_at_blanks(comment);
  if (fields.empty() || fields[0] != "box")
    return;
  if (list_.box)
    lines.fail(fmt::format("second \"# box\" line; only one is allowed, and line {} is one", box_line_));
  if (fields.size() != 7)
    lines.fail(fmt::format("\"# {}\" must be # box x0 y0 z0 x1 y1 z1 (m)", fmt::join(fields, " ")));
  Box box;
  for (int axis = 0; axis < 3; ++axis) {
    box.lower[axis] = lines.length("box", fields[1 + axis]);
    box.upper[axis] = lines.length("box", fields[4 + axis]);
  }
  list_.box = box;
  box_line_ = lines.number();
}

void SphereTable::add(const Fields& fields, const SphereColumns& columns, const TextLines& lines) {
  list_.spheres.push_back(sphere_in(fields, columns, lines));
  list_.origin.sphere_lines.push_back(lines.number());
}

SphereList SphereTable::list(const TextLines& lines) && {
  list_.origin.file = lines.file();
  list_.origin.box = fmt::format("{}:{}", lines.file(), box_line_);
  return std::move(list_);
}

} // namespace pfv
