#pragma once

#include "pfv/problem/case.hpp"

#include <array>
#include <vector>

namespace reference {

/// Area (m^2) that a face of the box cuts out of a sphere, inside the box.
double cut_area(const pfv::Sphere& sphere, pfv::Face face, const pfv::Box& box);

/// Gives every sphere cut by a Pressure face that pressure on its disc, and takes it as the face's too: from forces on
/// wetted surfaces to the forces of an Answer.
void add_pressure_on_discs(const pfv::Case& problem, std::vector<pfv::Vec3>& on_spheres,
                           std::array<pfv::Vec3, 6>& on_faces);

/// A sphere centred on a slip wall is half of a mirrored pair: what acts on it along the wall's normal is the wall's.
void give_normal_parts_to_slip_walls(const pfv::Case& problem, std::vector<pfv::Vec3>& on_spheres,
                                     std::array<pfv::Vec3, 6>& on_faces);

/// The same of a part of these forces, which no one asks of the faces.
void drop_normal_parts_at_slip_walls(const pfv::Case& problem, std::vector<pfv::Vec3>& on_spheres);

} // namespace reference
