#include "pfv/problem/error.hpp"
#include "pfv/problem/packing_file/formats.hpp"
#include "pfv/problem/packing_file/vtk/read_vtk_points.hpp"

#include <algorithm>
#include <cctype>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace pfv {
namespace {

bool same_name(std::string_view one, std::string_view other) {
  return std::ranges::equal(
      one, other, {}, [](unsigned char c) { return std::tolower(c); }, [](unsigned char c) { return std::tolower(c); });
}

const VtkArray* array_named(const std::vector<VtkArray>& arrays, std::string_view name) {
  const auto found = std::ranges::find_if(arrays, [&](const VtkArray& array) { return same_name(array.name, name); });
  return found == arrays.end() ? nullptr : &*found;
}

std::string names_of(const std::vector<VtkArray>& arrays) {
  std::vector<std::string_view> names;
  for (const VtkArray& array : arrays)
    names.push_back(array.name);
  return names.empty() ? "none" : fmt::format("{}", fmt::join(names, ", "));
}

/// The radius of every point.
std::vector<double> radii_in(const VtkPoints& read, const std::string& file) {
  for (const auto& [name, radius] : size_names)
    if (const VtkArray* array = array_named(read.of_points, name)) {
      if (array->components != 1 || 3 * array->values.size() != read.coordinates.size())
        throw InputError(fmt::format("{}: point array \"{}\" has {} values in {} components for {} points and must "
                                     "have one number for each",
                                     file, array->name, array->values.size(), array->components,
                                     read.coordinates.size() / 3));
      std::vector<double> radii = array->values;
      for (double& value : radii)
        value *= radius;
      return radii;
    }
  throw InputError(fmt::format("{}: point arrays \"{}\" must have one named radius, radii, r or diameter", file,
                               names_of(read.of_points)));
}

} // namespace

SphereList read_vtk_spheres(const std::string& file, const std::string& contents) {
  const VtkPoints read = read_vtk_points(file, contents);
  const std::vector<double> radii = radii_in(read, file);
  SphereList list;
  list.origin = {file, file, {}};
  for (std::size_t i = 0; i < radii.size(); ++i)
    list.spheres.push_back({Vec3(&read.coordinates[3 * i]), radii[i]});
  if (const VtkArray* box = array_named(read.of_file, "box"); box && box->values.size() == 6)
    list.box = Box{Vec3(&box->values[0]), Vec3(&box->values[3])};
  return list;
}

} // namespace pfv
