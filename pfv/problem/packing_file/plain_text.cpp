#include "pfv/problem/packing_file/formats.hpp"
#include "pfv/problem/packing_file/sphere_table.hpp"
#include "pfv/problem/text.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace pfv {
namespace {

struct Layout {
  SphereColumns columns;
  std::size_t count = 4; // of columns
  bool by_commas = false;

  Fields split(std::string_view text) const { return by_commas ? split_at_commas(text) : split_at_blanks(text); }
};

/// As ParaView writes them: "radius", "Points:0" for x.
std::string_view plain_name(std::string_view name) {
  if (name.size() >= 2 && name.starts_with('"') && name.ends_with('"'))
    name = name.substr(1, name.size() - 2);
  for (std::size_t axis = 0; axis < axis_names.size(); ++axis)
    if (name == fmt::format("Points:{}", axis))
      return axis_names[axis];
  return name;
}

/// Where the columns are when the line names them; nothing when it holds numbers.
std::optional<Layout> header(std::string_view content, const TextLines& lines) {
  Layout layout;
  layout.by_commas = content.find(',') != std::string_view::npos;
  Fields names = layout.split(content);
  if (std::ranges::any_of(names, [](std::string_view name) { return to_number(name).has_value(); }))
    return std::nullopt;
  layout.count = names.size();
  std::ranges::transform(names, names.begin(), plain_name);
  const auto columns = layout.by_commas || names.size() == 4 ? columns_named(names) : std::nullopt;
  if (!columns)
    lines.fail(
        fmt::format("columns \"{}\" must be x, y, z and one of r, radius, radii, diameter, each once, in any order",
                    shortened(fmt::format("{}", fmt::join(names, ",")))));
  layout.columns = *columns;
  return layout;
}

} // namespace

SphereList read_plain_text(const std::string& file, std::string_view contents) {
  TextLines lines(file, contents);
  SphereTable table;
  std::optional<Layout> layout;
  while (lines.next()) {
    const std::string_view content = table.without_comment(lines);
    if (split_at_blanks(content).empty())
      continue;
    if (!layout) {
      layout = header(content, lines);
      if (layout)
        continue;
      layout = Layout{};
    }
    const Fields fields = layout->split(content);
    if (fields.size() != layout->count)
      lines.fail(fmt::format(
          "\"{}\" has {} columns and must have {}", shortened(fmt::format("{}", fmt::join(fields, " "))), fields.size(),
          layout->by_commas ? fmt::format("{}, as its first line has", layout->count)
                            : "four, the numbers x y z r (m); CSV needs a first line that names them"));
    table.add(fields, layout->columns, lines);
  }
  return std::move(table).list(lines);
}

} // namespace pfv
