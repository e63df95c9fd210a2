#include "pfv/problem/generate.hpp"

#include "pfv/problem/error.hpp"
#include "pfv/problem/text.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <numbers>

namespace pfv {

namespace {

/// Whether a sphere sits at the point (i, j, k), counted in half cells from a corner of the box.
bool is_site(Lattice lattice, int i, int j, int k) {
  switch (lattice) {
  case Lattice::simple_cubic: // cell centres
    return i % 2 == 1 && j % 2 == 1 && k % 2 == 1;
  case Lattice::bcc: // cell corners and centres
    return i % 2 == j % 2 && j % 2 == k % 2;
  case Lattice::fcc: // cell corners and centres of the cell faces
    return (i + j + k) % 2 == 0;
  }
  return false;
}

} // namespace

double touching_solid_fraction(Lattice lattice) {
  switch (lattice) {
  case Lattice::simple_cubic:
    return std::numbers::pi / 6;
  case Lattice::bcc:
    return std::numbers::pi * std::numbers::sqrt3 / 8;
  case Lattice::fcc:
    return std::numbers::pi * std::numbers::sqrt2 / 6;
  }
  return 0;
}

Packing lattice_packing(Lattice lattice, double solid_fraction, int cells, double cell_size,
                        const PeriodicAxes& periodic) {
  const double touching = touching_solid_fraction(lattice);
  if (!(solid_fraction > 0 && solid_fraction <= touching * (1 + 1e-12)))
    throw InputError(fmt::format("solid_fraction \"{}\" must be above 0 and at most {}, where the spheres touch",
                                 shortest(solid_fraction), shortest(touching)));
  if (cells < 1)
    throw InputError(fmt::format("cells \"{}\" must be 1 or more", cells));
  if (!(std::isfinite(cell_size) && cell_size > 0))
    throw InputError(fmt::format("cell_size \"{}\" must be a positive number (m)", shortest(cell_size)));

  // Half the nearest distance when touching, exactly where a double can hold it: simple cubic spheres then end on the
  // walls.
  const double fraction = std::min(solid_fraction / touching, 1.0);
  const double nearest = lattice == Lattice::simple_cubic ? 1.0
                         : lattice == Lattice::bcc        ? std::numbers::sqrt3 / 2
                                                          : std::numbers::sqrt2 / 2;
  const double radius = std::cbrt(fraction) * nearest / 2 * cell_size;

  Packing packing{{Vec3::Zero(), Vec3::Constant(cells * cell_size)}, {}};
  const auto last = [&](Axis axis) { return 2 * cells - (periodic[index(axis)] ? 1 : 0); };
  for (int k = 0; k <= last(Axis::z); ++k)
    for (int j = 0; j <= last(Axis::y); ++j)
      for (int i = 0; i <= last(Axis::x); ++i)
        if (is_site(lattice, i, j, k))
          packing.spheres.push_back({Vec3(i, j, k) * (cell_size / 2), radius});
  return packing;
}

Packing nine_spheres(double size) {
  if (!(std::isfinite(size) && size > 0))
    throw InputError(fmt::format("size \"{}\" must be a positive number (m)", shortest(size)));
  const double radius = size / (2 + 4 / std::numbers::sqrt3);
  Packing packing{{Vec3::Zero(), Vec3::Constant(size)}, {}};
  const std::array<double, 2> ends{radius, size - radius};
  for (const double x : ends)
    for (const double y : ends)
      for (const double z : ends)
        packing.spheres.push_back({Vec3(x, y, z), radius});
  packing.spheres.push_back({Vec3::Constant(size / 2), radius});
  return packing;
}

} // namespace pfv
