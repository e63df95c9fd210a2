#pragma once

#include "pfv/problem/packing_file/sphere_list.hpp"

#include <filesystem>
#include <string>
#include <string_view>

namespace pfv {

enum class PackingFormat { plain_text, yade_export, lammps_dump, lammps_data, vtk };

/// What the contents of a file are: VTK when they are XML or legacy VTK, or when its name ends in .vtp, .vtu or .vtk; a
/// LAMMPS dump when they begin with "ITEM:"; LAMMPS data when one of the first lines ends with "xlo xhi"; YADE's export
/// when a comment before the first row begins with "#format"; plain text otherwise.
PackingFormat format_of(const std::filesystem::path& file, std::string_view contents);

// Each reads the contents of a file whose name is only for messages, and throws InputError.

SphereList read_plain_text(const std::string& file, std::string_view contents);

/// By yade.export.text and textExt: columns as "#format x_y_z_r_matId" names them; after the name attrs any number.
SphereList read_yade_export(const std::string& file, std::string_view contents);

/// By LAMMPS' and LIGGGHTS' dump custom: columns in any order, positions also scaled (xs) or unwrapped (xu, xsu), the
/// box from its bounds, into which positions are wrapped along periodic axes. The last snapshot is taken.
SphereList read_lammps_dump(const std::string& file, std::string_view contents);

/// By LAMMPS' write_data, and what its read_data takes: the box, and atoms of style sphere or granular.
SphereList read_lammps_data(const std::string& file, std::string_view contents);

/// Points with an array of their sizes, whatever the case of its name.
SphereList read_vtk_spheres(const std::string& file, const std::string& contents);

} // namespace pfv
