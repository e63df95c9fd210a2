#pragma once

#include "pfv/problem/packing_file/sphere_list.hpp"
#include "pfv/problem/packing_file/text_lines.hpp"

#include <array>
#include <string>

namespace pfv {

/// Which columns hold a sphere.
struct SphereColumns {
  std::array<std::size_t, 3> centre{0, 1, 2}; // of x, y and z
  std::size_t size = 3;
  SizeName size_name{"r", 1};
};

/// The sphere in the columns of the line that `lines` is at.
Sphere sphere_in(const Fields& fields, const SphereColumns& columns, const TextLines& lines);

/// Where the columns of these names are, x, y and z and one of size_names, or nothing unless each is there once.
std::optional<SphereColumns> columns_named(const Fields& names);

/// A table of spheres with comments after #, one of which may be `# box x0 y0 z0 x1 y1 z1`.
class SphereTable {
public:
  /// The line without its comment, of which the box is taken.
  std::string_view without_comment(const TextLines& lines);

  void add(const Fields& fields, const SphereColumns& columns, const TextLines& lines);

  SphereList list(const TextLines& lines) &&;

private:
  void take_box(std::string_view comment, const TextLines& lines);

  SphereList list_;
  int box_line_ = 0;
};

} // namespace pfv
