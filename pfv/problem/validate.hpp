#pragma once

#include "pfv/problem/case.hpp"

#include <span>
#include <string>
#include <vector>

namespace pfv {

/// Where the parts of a packing were written, for messages; empty for a packing that was not read.
struct PackingOrigin {
  std::string file;
  std::string box;               // "file:line", or the option that says it
  std::vector<int> sphere_lines; // empty when the file has no lines; its spheres are then points by number
};

/// "file:line", "file: point 3" or "spheres[3]".
std::string place_of_sphere(const PackingOrigin& origin, std::size_t sphere);

/// The parts of validate(case); each throws InputError on the first thing no method can work with.
void validate(const Packing& packing, const PackingOrigin& origin, const PeriodicAxes& periodic);
void validate(const Sphere& sphere, const std::string& place); // whatever its box
void validate(const Fluid& fluid);
void validate(const FaceConditions& faces);
void validate(const PressureInTime& pressure, Face face);
void validate(const PressurePoint& point, const Box& box);
void validate(const Buoyancy& buoyancy);

/// The pressure is known somewhere, or driven along a periodic axis: otherwise the flow has no cause, or no answer.
/// `or_else` ends the message with what else would do.
void validate_level(const FaceConditions& faces, std::span<const PressurePoint> points,
                    std::string_view or_else = "or a periodic axis a gradient");

} // namespace pfv
