#pragma once

#include "pfv/problem/face.hpp"
#include "pfv/problem/vec3.hpp"

#include <filesystem>
#include <iosfwd>
#include <vector>

namespace pfv {

struct Sphere {
  Vec3 centre;   // m
  double radius; // m

  bool operator==(const Sphere&) const = default;
};

/// Axis-aligned box that holds the packing.
struct Box {
  Vec3 lower = Vec3::Zero(); // m
  Vec3 upper = Vec3::Ones(); // m

  Vec3 size() const { return upper - lower; }
  double volume() const { return size().prod(); }
  bool operator==(const Box&) const = default;
};

struct Packing {
  Box box;
  std::vector<Sphere> spheres;

  bool operator==(const Packing&) const = default;
};

/// Reads a packing file in SI that says its box, as read_packing_file does. Throws InputError.
Packing read_packing(const std::filesystem::path& file, const PeriodicAxes& periodic = {});

/// Writes plain text, every number with the digits that read back to the same double.
void write_packing(const Packing& packing, std::ostream& out);

/// Throws InputError on the first thing no method can work with: an empty box or packing, a value that is not finite, a
/// radius that is not positive, a centre outside the box, two identical spheres. Where the box is periodic, a centre on
/// its upper face is the same as on its lower one.
void validate(const Packing& packing, const PeriodicAxes& periodic = {});

/// Volume of the spheres / volume of the box, each sphere counted whole, as it is in a periodic box: meaningless when
/// spheres overlap or are cut by walls.
double solid_fraction(const Packing& packing);

} // namespace pfv
