#include "pfv/problem/packing_file/formats.hpp"
#include "pfv/problem/packing_file/text_lines.hpp"

#include <algorithm>
#include <cctype>

namespace pfv {
namespace {

std::string lower_case(std::string text) {
  std::ranges::transform(text, text.begin(), [](unsigned char c) { return std::tolower(c); });
  return text;
}

bool names_its_format(std::string_view contents) {
  TextLines lines({}, contents);
  while (lines.next()) {
    if (lines.line().starts_with("#format"))
      return true;
    if (!lines.line().starts_with('#') && !split_at_blanks(lines.line()).empty())
      return false;
  }
  return false;
}

/// "0 1 xlo xhi" in what may be a header.
bool bounds_a_box(std::string_view contents) {
  constexpr int longest_header = 60;
  TextLines lines({}, contents);
  while (lines.next() && lines.number() <= longest_header) {
    const Fields words = split_at_blanks(lines.line());
    if (words.size() >= 4 && words[2] == "xlo" && words[3] == "xhi")
      return true;
  }
  return false;
}

} // namespace

PackingFormat format_of(const std::filesystem::path& file, std::string_view contents) {
  const std::string extension = lower_case(file.extension().string());
  const auto start = std::min(contents.find_first_not_of(" \t\r\n"), contents.size());
  if (extension == ".vtp" || extension == ".vtu" || extension == ".vtk" || contents.starts_with("# vtk DataFile") ||
      contents.substr(start).starts_with('<'))
    return PackingFormat::vtk;
  if (contents.starts_with("ITEM:"))
    return PackingFormat::lammps_dump;
  if (names_its_format(contents))
    return PackingFormat::yade_export;
  if (bounds_a_box(contents))
    return PackingFormat::lammps_data;
  return PackingFormat::plain_text;
}

} // namespace pfv
