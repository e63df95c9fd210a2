#include "reference/closed_form/recognise.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <set>

namespace reference {

namespace {

constexpr double tolerance = 1e-9;
constexpr std::array lattices{pfv::Lattice::simple_cubic, pfv::Lattice::bcc, pfv::Lattice::fcc};

using Site = std::array<long, 3>; // in half cells: every site of the three lattices has whole coordinates

std::size_t spheres_in_box(pfv::Lattice lattice, std::size_t n, const pfv::PeriodicAxes& periodic) {
  const auto planes = [&](std::size_t axis) { return periodic[axis] ? n : n + 1; };
  const std::size_t corners = planes(0) * planes(1) * planes(2);
  switch (lattice) {
  case pfv::Lattice::simple_cubic:
    return n * n * n;
  case pfv::Lattice::bcc:
    return corners + n * n * n;
  case pfv::Lattice::fcc:
    return corners + n * n * (planes(0) + planes(1) + planes(2));
  }
  return 0;
}

int spheres_per_cell(pfv::Lattice lattice) {
  return lattice == pfv::Lattice::simple_cubic ? 1 : lattice == pfv::Lattice::bcc ? 2 : 4;
}

// The sites of the spheres; nothing when one is away from any.
std::optional<std::set<Site>> sites(const pfv::Packing& packing, double cell) {
  std::set<Site> found;
  for (const pfv::Sphere& sphere : packing.spheres) {
    const pfv::Vec3 position = 2 * (sphere.centre - packing.box.lower) / cell;
    const pfv::Vec3 nearest = position.array().round();
    if ((position - nearest).cwiseAbs().maxCoeff() > 2 * tolerance)
      return std::nullopt;
    found.insert({std::lround(nearest.x()), std::lround(nearest.y()), std::lround(nearest.z())});
  }
  return found;
}

std::vector<double> parts_inside(const pfv::Packing& packing, double cell, const pfv::PeriodicAxes& periodic) {
  std::vector<double> parts;
  parts.reserve(packing.spheres.size());
  for (const pfv::Sphere& sphere : packing.spheres) {
    const pfv::Vec3 to_face =
        (sphere.centre - packing.box.lower).cwiseAbs().cwiseMin((packing.box.upper - sphere.centre).cwiseAbs());
    int faces = 0;
    for (int axis = 0; axis < 3; ++axis)
      faces += !periodic[static_cast<std::size_t>(axis)] && to_face[axis] < tolerance * cell;
    parts.push_back(std::pow(0.5, faces));
  }
  return parts;
}

std::optional<RecognisedLattice> recognise_as(pfv::Lattice lattice, int cells, const pfv::Packing& packing,
                                              const pfv::PeriodicAxes& periodic) {
  const double cell = packing.box.size().x() / cells;
  const double sphere = 4.0 / 3.0 * std::numbers::pi * std::pow(packing.spheres.front().radius, 3);
  const double touching = pfv::touching_solid_fraction(lattice);
  double fraction = spheres_per_cell(lattice) * sphere / std::pow(cell, 3);
  if (fraction > touching * (1 + 10 * tolerance))
    return std::nullopt;
  fraction = std::min(fraction, touching);
  const auto expected = sites(pfv::lattice_packing(lattice, fraction, cells, cell, periodic), cell);
  const auto found = sites(packing, cell);
  if (!expected || found != expected)
    return std::nullopt;
  return RecognisedLattice{lattice, cells, fraction, parts_inside(packing, cell, periodic)};
}

} // namespace

std::optional<RecognisedLattice> recognise_lattice(const pfv::Packing& packing, const pfv::PeriodicAxes& periodic) {
  const pfv::Vec3 size = packing.box.size();
  if (packing.spheres.empty() || size.maxCoeff() > size.minCoeff() * (1 + tolerance))
    return std::nullopt;
  const double radius = packing.spheres.front().radius;
  if (std::ranges::any_of(packing.spheres, [&](const pfv::Sphere& sphere) {
        return std::abs(sphere.radius - radius) > tolerance * radius;
      }))
    return std::nullopt;
  for (const pfv::Lattice lattice : lattices)
    for (int cells = 1; spheres_in_box(lattice, static_cast<std::size_t>(cells), periodic) <= packing.spheres.size();
         ++cells)
      if (spheres_in_box(lattice, static_cast<std::size_t>(cells), periodic) == packing.spheres.size())
        if (auto found = recognise_as(lattice, cells, packing, periodic))
          return found;
  return std::nullopt;
}

} // namespace reference
