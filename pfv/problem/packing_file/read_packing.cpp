#include "pfv/problem/error.hpp"
#include "pfv/problem/packing_file.hpp"
#include "pfv/problem/packing_file/formats.hpp"
#include "pfv/problem/packing_file/text_lines.hpp"
#include "pfv/problem/text.hpp"
#include "pfv/problem/validate.hpp"

#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace pfv {
namespace {

SphereList read_as(PackingFormat format, const std::string& file, const std::string& contents, std::string_view text) {
  switch (format) {
  case PackingFormat::vtk:
    return read_vtk_spheres(file, contents);
  case PackingFormat::lammps_dump:
    return read_lammps_dump(file, text);
  case PackingFormat::lammps_data:
    return read_lammps_data(file, text);
  case PackingFormat::yade_export:
    return read_yade_export(file, text);
  case PackingFormat::plain_text:
    break;
  }
  if (text.find('\0') != std::string_view::npos)
    throw InputError(fmt::format("{}: neither text nor VTK: it must be one of x y z r, CSV, YADE's export, LAMMPS' "
                                 "dump and data, .vtp, .vtu and .vtk",
                                 file));
  return read_plain_text(file, text);
}

SphereList read_spheres(const std::filesystem::path& file) {
  const std::string contents = read_text(file);
  std::string_view text = contents;
  if (text.starts_with("\xEF\xBB\xBF")) // spreadsheets lead CSV with a byte order mark
    text.remove_prefix(3);
  try {
    return read_as(format_of(file, text), file.string(), contents, text);
  } catch (const InputError& error) { // which may quote anything
    throw InputError(printable(error.what()));
  }
}

/// The smallest box with all of the spheres, as --box takes it.
std::string bounding_box(const std::vector<Sphere>& spheres) {
  Box box{spheres[0].centre, spheres[0].centre};
  for (const auto& [centre, radius] : spheres) {
    box.lower = box.lower.cwiseMin((centre.array() - radius).matrix());
    box.upper = box.upper.cwiseMax((centre.array() + radius).matrix());
  }
  const auto& [lower, upper] = box;
  return fmt::format("{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g}", lower.x(), lower.y(), lower.z(), upper.x(), upper.y(),
                     upper.z());
}

[[noreturn]] void fail_without_box(const SphereList& list) {
  const std::string& file = list.origin.file;
  for (std::size_t i = 0; i < list.spheres.size(); ++i)
    validate(list.spheres[i], place_of_sphere(list.origin, i));
  throw InputError(fmt::format("{}: no box; --box, box in [packing] or, in text, a line \"# box x0 y0 z0 x1 y1 z1\" "
                               "must say it; that of the spheres is --box {}",
                               file, bounding_box(list.spheres)));
}

std::string names_of(const PeriodicAxes& periodic) {
  std::vector<std::string_view> names;
  for (int axis = 0; axis < 3; ++axis)
    if (periodic[axis])
      names.push_back(axis_names[axis]);
  return names.empty() ? "no axis" : fmt::format("{}", fmt::join(names, ", "));
}

} // namespace

ReadPacking read_packing_file(const std::filesystem::path& file, const PackingFileOptions& options,
                              const PeriodicAxes& periodic) {
  const double scale = options.scale.value_or(1);
  validate_scale(scale);
  SphereList list = read_spheres(file);
  if (list.spheres.empty())
    throw InputError(fmt::format("{}: packing has \"0\" spheres and needs at least one", file.string()));
  if (options.box) {
    list.box = options.box;
    list.origin.box = options.box_place;
  }
  if (!list.box)
    fail_without_box(list);
  for (auto& [centre, radius] : list.spheres) {
    centre *= scale;
    radius *= scale;
  }
  ReadPacking read{{{scale * list.box->lower, scale * list.box->upper}, std::move(list.spheres)},
                   std::move(list.notes)};
  validate(read.packing, list.origin, periodic);
  if (list.periodic && *list.periodic != periodic)
    read.notes.push_back(fmt::format("{}: its box repeats along {}, that of the question along {}", file.string(),
                                     names_of(*list.periodic), names_of(periodic)));
  return read;
}

Packing read_packing(const std::filesystem::path& file, const PeriodicAxes& periodic) {
  return read_packing_file(file, {}, periodic).packing;
}

void validate_scale(double scale) {
  if (!(scale > 0 && std::isfinite(scale)))
    throw InputError(fmt::format("scale \"{}\" must be a positive number, the length in m of one unit of the file",
                                 shortest(scale)));
}

Box box_named(std::string_view corners) {
  const Fields fields = split_at_commas(corners);
  Box box;
  for (std::size_t i = 0; i < 6; ++i) {
    const auto value = fields.size() == 6 ? to_number(fields[i]) : std::nullopt;
    if (!value)
      throw InputError(fmt::format("box \"{}\" must be six numbers x0,y0,z0,x1,y1,z1", corners));
    (i < 3 ? box.lower : box.upper)[static_cast<int>(i % 3)] = *value;
  }
  return box;
}

} // namespace pfv
