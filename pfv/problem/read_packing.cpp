#include "pfv/problem/error.hpp"
#include "pfv/problem/packing.hpp"
#include "pfv/problem/text.hpp"
#include "pfv/problem/validate.hpp"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <optional>

namespace pfv {

namespace {

using Fields = std::vector<std::string_view>;

/// The non-empty parts of `text` between separators; between commas a part may be empty.
Fields split(std::string_view text, bool by_commas) {
  constexpr std::string_view blanks = " \t\r\f\v";
  Fields fields;
  while (true) {
    const auto start = text.find_first_not_of(blanks);
    text.remove_prefix(std::min(start, text.size()));
    if (text.empty() && !by_commas)
      return fields;
    const auto end = by_commas ? text.find(',') : text.find_first_of(blanks);
    const std::string_view field = text.substr(0, end);
    fields.push_back(field.substr(0, field.find_last_not_of(blanks) + 1));
    if (end == std::string_view::npos)
      return fields;
    text.remove_prefix(end + 1);
  }
}

constexpr std::array<std::string_view, 4> quantities{"x", "y", "z", "r"};

struct Layout {
  std::array<std::size_t, 4> columns{0, 1, 2, 3}; // of x, y, z and r
  bool by_commas = false;
};

class PackingReader {
public:
  PackingReader(const std::filesystem::path& file, const PeriodicAxes& periodic)
      : text_(read_text(file)), periodic_(periodic) {
    origin_.file = file.string();
  }

  Packing read() && {
    std::string_view rest = text_;
    if (rest.starts_with("\xEF\xBB\xBF")) // spreadsheets lead CSV with a byte order mark
      rest.remove_prefix(3);
    while (!rest.empty()) {
      ++line_;
      const auto end = std::min(rest.find('\n'), rest.size());
      read_line(rest.substr(0, end));
      rest.remove_prefix(std::min(end + 1, rest.size()));
    }
    if (!box_)
      throw InputError(fmt::format("{}:{}: no \"# box x0 y0 z0 x1 y1 z1\" line; one is needed (m)", origin_.file,
                                   std::max(line_, 1)));
    Packing packing{*box_, std::move(spheres_)};
    validate(packing, origin_, periodic_);
    return packing;
  }

private:
  void read_line(std::string_view line) {
    const auto comment = std::min(line.find('#'), line.size());
    read_comment(line.substr(comment));
    const std::string_view content = line.substr(0, comment);
    if (split(content, false).empty())
      return;
    if (!layout_) {
      const bool by_commas = content.find(',') != std::string_view::npos;
      const auto columns = header(split(content, by_commas));
      layout_ = columns ? Layout{*columns, by_commas} : Layout{};
      if (columns)
        return;
    }
    read_sphere(split(content, layout_->by_commas));
  }

  void read_comment(std::string_view comment) {
    const Fields fields = split(comment.substr(std::min<std::size_t>(1, comment.size())), false);
    if (fields.empty() || fields[0] != "box")
      return;
    if (box_)
      fail(fmt::format("second \"# box\" line; only one is allowed, and line {} is one", origin_.box_line));
    if (fields.size() != 7)
      fail(fmt::format("\"# {}\" must be # box x0 y0 z0 x1 y1 z1 (m)", fmt::join(fields, " ")));
    Box box;
    for (int i = 0; i < 3; ++i) {
      box.lower[i] = number("box", fields[1 + i]);
      box.upper[i] = number("box", fields[4 + i]);
    }
    box_ = box;
    origin_.box_line = line_;
  }

  /// Where x, y, z and r are when the line names the columns; nothing when it holds numbers.
  std::optional<std::array<std::size_t, 4>> header(const Fields& fields) const {
    if (std::ranges::any_of(fields, [](std::string_view field) { return to_number(field).has_value(); }))
      return std::nullopt;
    const auto short_name = [](std::string_view field) { return field == "radius" ? "r" : field; };
    std::array<std::size_t, 4> columns{};
    for (std::size_t i = 0; i < 4; ++i) {
      if (fields.size() != 4 || std::ranges::count(fields, quantities[i], short_name) != 1)
        fail(fmt::format("columns \"{}\" must be x, y, z and r (or radius), each once, in any order",
                         fmt::join(fields, ",")));
      columns[i] = std::ranges::find(fields, quantities[i], short_name) - fields.begin();
    }
    return columns;
  }

  void read_sphere(const Fields& fields) {
    if (fields.size() != 4)
      fail(fmt::format("\"{}\" has {} columns and must have four, the numbers x y z r (m){}", fmt::join(fields, " "),
                       fields.size(), layout_->by_commas ? "" : "; CSV needs a first line that names them"));
    std::array<double, 4> values{};
    for (std::size_t i = 0; i < 4; ++i)
      values[i] = number(quantities[i], fields[layout_->columns[i]]);
    spheres_.push_back({Vec3(values[0], values[1], values[2]), values[3]});
    origin_.sphere_lines.push_back(line_);
  }

  double number(std::string_view name, std::string_view field) const {
    const auto value = to_number(field);
    if (!value)
      fail(fmt::format("{} \"{}\" must be a number (m)", name, field));
    return *value;
  }

  [[noreturn]] void fail(const std::string& message) const {
    throw InputError(fmt::format("{}:{}: {}", origin_.file, line_, message));
  }

  std::string text_;
  PeriodicAxes periodic_;
  PackingOrigin origin_;
  int line_ = 0;
  std::optional<Layout> layout_;
  std::optional<Box> box_;
  std::vector<Sphere> spheres_;
};

} // namespace

Packing read_packing(const std::filesystem::path& file, const PeriodicAxes& periodic) {
  return PackingReader(file, periodic).read();
}

} // namespace pfv
