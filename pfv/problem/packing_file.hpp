#pragma once

#include "pfv/problem/packing.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace pfv {

/// What is said of a packing file that it does not say itself.
struct PackingFileOptions {
  std::optional<double> scale = {}; // m, length of one unit of the file and of `box`; 1 when not said
  std::optional<Box> box = {};      // in the unit of the file; takes the place of the file's own
  std::string box_place = "--box";  // where it was said, for messages
};

/// Throws InputError unless it is a positive number.
void validate_scale(double scale);

/// "x0,y0,z0,x1,y1,z1" as a box. Throws InputError.
Box box_named(std::string_view corners);

struct ReadPacking {
  Packing packing;
  std::vector<std::string> notes; // what the reader chose and its user may want to know, a line each
};

/// Reads a packing file, whose format is told by its contents:
///   plain text     `# box x0 y0 z0 x1 y1 z1`, then `x y z r` per line; or, when the first line that is not a comment
///                  names the columns, CSV (x, y, z and r, radius, radii or diameter in any order)
///   YADE's export  begins with `#format x_y_z_r`, where more columns may be named
///   LAMMPS dump    begins with `ITEM:`; the last snapshot is taken
///   VTK            XML (.vtp, .vtu) or legacy (.vtk): points with an array radius, radii, r or diameter
/// The box is that of the options, or that of the file: the comment in text, the bounds of a dump, a field array `box`
/// of six values in VTK. Lengths are multiplied by the scale, and the packing is validated.
/// Throws InputError naming file, line (in text), value and what is allowed; where no box is said, it quotes that of
/// the spheres.
ReadPacking read_packing_file(const std::filesystem::path& file, const PackingFileOptions& options = {},
                              const PeriodicAxes& periodic = {});

} // namespace pfv
