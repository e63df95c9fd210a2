#pragma once

#include "pfv/problem/case.hpp"

#include <toml++/toml.h>
#include <variant>
#include <vector>

namespace pfv {

/// [flow] of a case: flow_along, before the box is known.
struct FlowAlong {
  Axis axis = Axis::z;
  double pressure_drop = 1; // Pa
  PeriodicAxes periodic = {};
  Tangential tangential = Tangential::zero;
};

/// What a case says of its faces, in [flow] or in [faces].
using FaceInput = std::variant<FlowAlong, FaceConditions>;

/// What a scene says of its faces. Those whose pressure changes have that of the time zero.
struct FacesInTime {
  FaceConditions faces{};
  PressuresInTime pressures{};
};

/// All of these throw InputError with file and line.
PeriodicAxes as_periodic_axes(const toml::node& node);
FlowAlong read_flow(const toml::table& table);
FaceConditions read_faces(const toml::table& table); // of a case: no pressure changes in time
FacesInTime read_faces_in_time(const toml::table& table);
std::vector<PressurePoint> read_pressure_points(const toml::node& node, const Box& box);

} // namespace pfv
