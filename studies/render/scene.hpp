#pragma once

#include "pfv/problem/packing.hpp"

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace studies {

/// A rectangle with a colour for each of its fields, which are as wide as they are high, more or less.
struct Panel {
  pfv::Vec3 corner, across, up; // m; the sides of the rectangle begin at the corner
  int columns = 0, rows = 0;
  std::vector<std::array<std::uint8_t, 3>> colours = {}; // red, green, blue; row by row from the corner
};

/// What a picture in space shows: spheres as far as they are within the pieces, panels, and the box as a frame.
struct RenderScene {
  pfv::Box box;
  std::vector<pfv::Box> pieces; // of the box, side by side
  std::vector<pfv::Sphere> spheres;
  std::vector<Panel> panels;
  pfv::Vec3 towards_eye, upwards; // of any length
};

/// The scene as JSON, and back. Reading throws pfv::InputError.
std::string to_json(const RenderScene& scene);
RenderScene render_scene_from(std::string_view json);

} // namespace studies
