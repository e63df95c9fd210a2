#pragma once

#include <string>
#include <vector>

namespace pfv {

/// A named array: `values` holds `components` numbers for each of its tuples.
struct VtkArray {
  std::string name;
  int components;
  std::vector<double> values;
};

/// The points of a VTK file, what it says of each, and what it says of the whole.
struct VtkPoints {
  std::vector<double> coordinates; // x, y, z of the first point, then of the second
  std::vector<VtkArray> of_points, of_file;
};

/// Reads the contents of a VTK file: XML (.vtp of PolyData, .vtu of UnstructuredGrid) or legacy (.vtk). `file` is its
/// name for messages. Throws InputError when it is none of these or damaged, or when this build has no VTK.
VtkPoints read_vtk_points(const std::string& file, const std::string& contents);

} // namespace pfv
