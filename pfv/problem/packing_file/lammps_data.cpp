#include "pfv/problem/packing_file/formats.hpp"
#include "pfv/problem/packing_file/sphere_table.hpp"
#include "pfv/problem/text.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace pfv {
namespace {

constexpr SphereColumns columns{{4, 5, 6}, 2, {"diameter", 0.5}}; // id type diameter density x y z
constexpr std::size_t least_columns = 7, with_images = 10;        // the box that an atom is unwrapped into

class DataReader {
public:
  DataReader(const std::string& file, std::string_view contents) : lines_(file, contents) { list_.origin.file = file; }

  SphereList read() && {
    lines_.next(); // the first is a title, whatever it says
    while (lines_.next()) {
      const Fields words = split_at_blanks(content());
      if (words.empty())
        continue;
      if (words[0] == "Atoms" && words.size() == 1) {
        read_atoms();
        return std::move(list_);
      }
      read_header(words);
    }
    lines_.fail("the file ends before its section Atoms");
  }

private:
  std::string_view content() const { return lines_.line().substr(0, lines_.line().find('#')); }

  /// "12 atoms", "0 1 xlo xhi"; what else a header has says nothing of spheres.
  void read_header(const Fields& words) {
    if (words.size() == 2 && words[1] == "atoms")
      atoms_ = lines_.count("number of atoms", words[0]);
    else if (words.size() == 6 && words[3] == "xy")
      lines_.fail(fmt::format("box \"{}\" must be orthogonal, without xy xz yz", fmt::join(words, " ")));
    else if (words.size() == 4)
      for (int axis = 0; axis < 3; ++axis)
        if (words[2] == std::string(axis_names[axis]) + "lo") {
          box_.lower[axis] = lines_.length(words[2], words[0]);
          box_.upper[axis] = lines_.length(words[3], words[1]);
          bounded_[static_cast<std::size_t>(axis)] = true;
          list_.origin.box = fmt::format("{}:{}", lines_.file(), lines_.number());
        }
  }

  void read_atoms() {
    if (!atoms_ || !std::ranges::all_of(bounded_, [](bool told) { return told; }))
      lines_.fail("the section Atoms must follow the number of atoms and xlo xhi, ylo yhi, zlo zhi");
    list_.box = box_;
    read_style();
    while (list_.spheres.size() < *atoms_) {
      if (!lines_.next())
        lines_.fail(fmt::format("the file ends before {} atoms, after {}", *atoms_, list_.spheres.size()));
      const Fields fields = split_at_blanks(content());
      if (fields.empty() && list_.spheres.empty())
        continue;
      if (fields.size() != least_columns && fields.size() != with_images)
        lines_.fail(fmt::format("\"{}\" has {} columns and must have 7, id type diameter density x y z, or 10",
                                shortened(fmt::format("{}", fmt::join(fields, " "))), fields.size()));
      list_.spheres.push_back(sphere_in(fields, columns, lines_));
      list_.origin.sphere_lines.push_back(lines_.number());
    }
  }

  /// After the name of the section: "Atoms # sphere".
  void read_style() {
    const auto hint = lines_.line().find('#');
    const Fields style = split_at_blanks(hint == std::string_view::npos ? "" : lines_.line().substr(hint + 1));
    if (style.empty())
      list_.notes.push_back(fmt::format("{}: its atoms have no style: read as id type diameter density x y z, those of "
                                        "sphere and granular",
                                        lines_.file()));
    else if (style[0] != "sphere" && style[0] != "granular")
      lines_.fail(
          fmt::format("atom style \"{}\" must be sphere or granular: others have no diameters", shortened(style[0])));
  }

  TextLines lines_;
  SphereList list_;
  Box box_;
  std::array<bool, 3> bounded_{};
  std::optional<std::size_t> atoms_;
};

} // namespace

SphereList read_lammps_data(const std::string& file, std::string_view contents) {
  return DataReader(file, contents).read();
}

} // namespace pfv
