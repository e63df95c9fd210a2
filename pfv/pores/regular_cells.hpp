#pragma once

#include "pfv/pores/triangulate.hpp"

#include <span>

namespace pfv {

/// The finite cells of the regular triangulation of spheres and of the faces of a box (0, 0, 0) to `size` that are not
/// periodic; lengths of order 1. Fills `cells` and `neighbours` of the result; a periodic face adds nothing. What CGAL
/// itself takes is stage `triangulate`.
Triangulation regular_cells(std::span<const Sphere> spheres, const Vec3& size, const PeriodicAxes& periodic,
                            Clock& clock);

} // namespace pfv
