#include "pfv/problem/packing_file/formats.hpp"
#include "pfv/problem/packing_file/sphere_table.hpp"
#include "pfv/problem/text.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace pfv {
namespace {

struct Format {
  std::string name;
  SphereColumns columns;
  std::size_t named = 0;
  bool open = false; // more columns may follow
};

/// "#format x_y_z_r_matId": the columns, joined by underscores.
Format format_in(const TextLines& lines) {
  const Fields words = split_at_blanks(lines.line());
  Format format;
  format.name = words.size() == 2 ? words[1] : std::string_view{};
  std::string spaced = format.name;
  std::ranges::replace(spaced, '_', ' ');
  const Fields names = split_at_blanks(spaced);
  const auto columns = columns_named(names);
  if (!columns)
    lines.fail(fmt::format("\"{}\" must name columns x, y, z and r, as #format x_y_z_r_matId does",
                           shortened(fmt::format("{}", fmt::join(words, " ")))));
  format.columns = *columns;
  format.open = names.back() == "attrs";
  format.named = names.size() - (format.open ? 1 : 0);
  return format;
}

void require_columns(const Fields& fields, const Format& format, const TextLines& lines) {
  if (fields.size() == format.named || (format.open && fields.size() > format.named))
    return;
  lines.fail(fmt::format("\"{}\" has {} columns and must have {}{} as #format {} says",
                         shortened(fmt::format("{}", fmt::join(fields, " "))), fields.size(), format.named,
                         format.open ? " or more" : "", format.name));
}

} // namespace

SphereList read_yade_export(const std::string& file, std::string_view contents) {
  TextLines lines(file, contents);
  SphereTable table;
  std::optional<Format> format;
  while (lines.next()) {
    if (lines.line().starts_with("#format")) {
      if (format)
        lines.fail(fmt::format("second \"#format\" line; only one is allowed"));
      format = format_in(lines);
      continue;
    }
    const Fields fields = split_at_blanks(table.without_comment(lines));
    if (fields.empty())
      continue;
    require_columns(fields, format.value(), lines);
    table.add(fields, format->columns, lines);
  }
  return std::move(table).list(lines);
}

} // namespace pfv
