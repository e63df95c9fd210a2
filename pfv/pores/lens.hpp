#pragma once

#include "pfv/pores/lanes.hpp"

#include <algorithm>

/// Where spheres overlap, or reach across a facet, part of their volume would be counted twice or outside the facet.
/// Two spheres are parted by their radical plane, so that each keeps what lies on its own side. All angles in radians.
namespace pfv::lens {

/// Distance of the radical plane of two spheres from the first centre, along the line to the second.
PFV_INLINE double radical_distance(double apart, double radius, double other) {
  return 0.5 * (apart + (radius - other) * (radius + other) / apart);
}

/// Half of the segment of a disc beyond a line at `distance` from its centre; 0 when the line passes by.
PFV_INLINE double half_segment(double radius, double distance) {
  double cosine = distance / radius;
  cosine = cosine > 1 ? 1 : cosine;
  cosine = cosine < -1 ? -1 : cosine;
  const double sine = std::sqrt(1 - cosine * cosine);
  return 0.5 * radius * radius * (lanes::atan2(sine, cosine) - sine * cosine);
}

/// Height of the cap of a sphere beyond a plane at `distance` from its centre.
PFV_INLINE double cap_height(double radius, double distance) {
  double height = radius - distance;
  height = height > 0 ? height : 0;
  return height < 2 * radius ? height : 2 * radius;
}

/// The part of a cap in a dihedral angle about its axis.
PFV_INLINE double cap_volume(double radius, double height, double dihedral) {
  return height * height * (3 * radius - height) * dihedral / 6;
}
PFV_INLINE double cap_surface(double radius, double height, double dihedral) {
  return radius * height * dihedral;
}

/// The part of a disc's sector that reaches across the opposite side of its triangle: the side's line is at `distance`
/// from the centre, its ends at `from` < `to` along it, seen from the foot of the centre.
PFV_INLINE double reach_across(double radius, double distance, double from, double to) {
  const double chord = radius > distance ? std::sqrt((radius - distance) * (radius + distance)) : 0;
  const double low = from > -chord ? from : -chord;
  const double high = to < chord ? to : chord;
  const double turn = lanes::atan2(high, distance) - lanes::atan2(low, distance);
  return high > low ? 0.5 * (radius * radius * turn - distance * (high - low)) : 0;
}

} // namespace pfv::lens
