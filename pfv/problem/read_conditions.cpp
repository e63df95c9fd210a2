#include "pfv/problem/read_conditions.hpp"

#include "pfv/problem/toml_input.hpp"
#include "pfv/problem/validate.hpp"

#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace pfv {

namespace {

Axis as_axis(const toml::node& node, std::string_view name) {
  const std::string text = as_text(node, name);
  return located(node, [&] { return axis_named(text); });
}

Tangential as_tangential(const toml::node& node) {
  const std::string text = as_text(node, "tangential");
  if (text == tangential_names[0])
    return Tangential::zero;
  if (text == tangential_names[1])
    return Tangential::free;
  fail_at(node, fmt::format("tangential \"{}\" must be one of {}", text, fmt::join(tangential_names, ", ")));
}

constexpr std::string_view in_time = "time"; // what a pressure is along, instead of an axis

bool is_in_time(const toml::node& face) {
  const auto* table = face.as_table();
  return table && (*table)["along"].value<std::string_view>() == in_time && (*table)["pressure"].is_array();
}

/// Of a pressure along an axis or in time: `place` reads like "position (m)".
template <class Point>
std::vector<Point> read_points(const toml::array& list, std::string_view place) {
  std::vector<Point> points;
  for (const toml::node& point : list) {
    const auto* pair = point.as_array();
    if (!pair || pair->size() != 2)
      fail_at(point, fmt::format("pressure \"{}\" must be two numbers [{}, pressure (Pa)]", quote(point), place));
    points.push_back({as_number((*pair)[0], place), as_number((*pair)[1], "pressure")});
  }
  return points;
}

PressureInTime read_in_time(const toml::node& node, Face face) {
  const toml::table& table = *node.as_table();
  allow_keys(table, fmt::format("{} with a pressure in time", face_names[index(face)]), {"pressure", "along"});
  PressureInTime pressure{read_points<PressureInTime::Point>(*table.get("pressure")->as_array(), "time (s)")};
  located(node, [&] { validate(pressure, face); });
  return pressure;
}

FaceCondition read_face(const toml::node& node, std::string_view name) {
  if (const auto* text = node.as_string(); text && text->get() == "slip")
    return SlipWall{};
  else if (text && text->get() == "periodic")
    return Periodic{};
  const auto* table = node.as_table();
  if (!table)
    fail_at(node, fmt::format("{} \"{}\" must be \"slip\", \"periodic\", {{ pressure = <Pa> }}, {{ pressure = [[<m>, "
                              "<Pa>], ...], along = <axis> }}, {{ flux = <m^3/s> }} or {{ periodic = <Pa/m> }}",
                              name, quote(node)));
  if (const toml::node* flux = table->get("flux")) {
    allow_keys(*table, fmt::format("{} with a flux", name), {"flux"});
    return Flux{as_number(*flux, "flux")};
  }
  if (const toml::node* gradient = table->get("periodic")) {
    allow_keys(*table, fmt::format("{} with periodic", name), {"periodic"});
    return Periodic{as_number(*gradient, "periodic")};
  }
  const toml::node* pressure = table->get("pressure");
  if (const auto* points = pressure ? pressure->as_array() : nullptr) {
    allow_keys(*table, fmt::format("{} with a pressure profile", name), {"pressure", "along"});
    return PressureProfile{as_axis(required(*table, name, "along"), "along"),
                           read_points<PressureProfile::Point>(*points, "position (m)")};
  }
  allow_keys(*table, name, {"pressure", "tangential", "flux", "periodic"});
  Pressure open{as_number(required(*table, name, "pressure"), "pressure")};
  if (const toml::node* tangential = table->get("tangential"))
    open.tangential = as_tangential(*tangential);
  return open;
}

} // namespace

PeriodicAxes as_periodic_axes(const toml::node& node) {
  const auto* list = node.as_array();
  if (!list)
    fail_at(node, fmt::format("periodic \"{}\" must be a list of axes, [\"x\", \"y\", \"z\"] or fewer", quote(node)));
  PeriodicAxes periodic{};
  for (const toml::node& name : *list)
    periodic[index(as_axis(name, "periodic"))] = true;
  return periodic;
}

FlowAlong read_flow(const toml::table& table) {
  allow_keys(table, "[flow]", {"axis", "pressure_drop", "periodic", "tangential"});
  FlowAlong flow;
  flow.axis = as_axis(required(table, "[flow]", "axis"), "axis");
  if (const toml::node* drop = table.get("pressure_drop")) {
    flow.pressure_drop = as_number(*drop, "pressure_drop");
    if (!std::isfinite(flow.pressure_drop) || flow.pressure_drop == 0)
      fail_at(*drop, fmt::format("pressure_drop \"{}\" must be a finite number other than zero (Pa)", quote(*drop)));
  }
  if (const toml::node* periodic = table.get("periodic"))
    flow.periodic = as_periodic_axes(*periodic);
  if (const toml::node* tangential = table.get("tangential"))
    flow.tangential = as_tangential(*tangential);
  return flow;
}

FacesInTime read_faces_in_time(const toml::table& table) {
  allow_keys(table, "[faces]", {"x_min", "x_max", "y_min", "y_max", "z_min", "z_max"});
  FacesInTime read;
  for (const Face face : all_faces) {
    const toml::node* node = table.get(face_names[index(face)]);
    if (!node)
      continue;
    auto& changing = read.pressures[index(face)];
    if (is_in_time(*node))
      changing = read_in_time(*node, face);
    read.faces[index(face)] = changing ? Pressure{changing->at(0)} : read_face(*node, face_names[index(face)]);
  }
  located(table, [&] { validate(read.faces); });
  return read;
}

FaceConditions read_faces(const toml::table& table) {
  for (const Face face : all_faces)
    if (const toml::node* node = table.get(face_names[index(face)]); node && is_in_time(*node))
      fail_at(*node, fmt::format("{} pressure along \"{}\" is for scenes of pfv run: the flow of a case is steady",
                                 face_names[index(face)], in_time));
  return read_faces_in_time(table).faces;
}

std::vector<PressurePoint> read_pressure_points(const toml::node& node, const Box& box) {
  const auto* list = node.as_array();
  if (!list)
    fail_at(node, fmt::format("pressure_points \"{}\" must be a list of tables [[pressure_points]]", quote(node)));
  std::vector<PressurePoint> points;
  for (const toml::node& entry : *list) {
    const toml::table& table = as_table(entry, "pressure_points");
    allow_keys(table, "[[pressure_points]]", {"position", "pressure"});
    points.push_back({as_vector(required(table, "[[pressure_points]]", "position"), "position"),
                      as_number(required(table, "[[pressure_points]]", "pressure"), "pressure")});
    located(table, [&] { validate(points.back(), box); });
  }
  return points;
}

} // namespace pfv
