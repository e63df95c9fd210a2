#pragma once

#include "pfv/problem/vec3.hpp"

#include <array>
#include <span>
#include <string>
#include <string_view>

namespace pfv {

enum class Axis { x, y, z };

/// The six faces of the box; face 2 axis is its lower side, face 2 axis + 1 its upper side.
enum class Face { x_min, x_max, y_min, y_max, z_min, z_max };

inline constexpr std::array all_faces{Face::x_min, Face::x_max, Face::y_min, Face::y_max, Face::z_min, Face::z_max};
inline constexpr std::array<std::string_view, 6> face_names{"x_min", "x_max", "y_min", "y_max", "z_min", "z_max"};
inline constexpr std::array<std::string_view, 3> axis_names{"x", "y", "z"};

constexpr int index(Axis axis) {
  return static_cast<int>(axis);
}
constexpr int index(Face face) {
  return static_cast<int>(face);
}
constexpr Axis axis_of(Face face) {
  return static_cast<Axis>(index(face) / 2);
}
constexpr bool is_upper(Face face) {
  return index(face) % 2 == 1;
}
constexpr Face lower_face(Axis axis) {
  return static_cast<Face>(2 * index(axis));
}
constexpr Face upper_face(Axis axis) {
  return static_cast<Face>(2 * index(axis) + 1);
}

/// Unit normal that points out of the box.
inline Vec3 outward_normal(Face face) {
  return (is_upper(face) ? 1.0 : -1.0) * Vec3::Unit(index(axis_of(face)));
}

/// The axis of that name. Throws InputError.
Axis axis_named(std::string_view name);

/// By index(Axis): whether the box repeats without end along it.
using PeriodicAxes = std::array<bool, 3>;

/// The axes of those names. Throws InputError.
PeriodicAxes axes_named(std::span<const std::string> names);

} // namespace pfv
