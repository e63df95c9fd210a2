#include "reference/walls_and_pressures.hpp"

#include <fmt/format.h>

namespace reference {

namespace {

struct Beyond {
  const char* operator()(const pfv::SlipWall&) const { return nullptr; }
  const char* operator()(const pfv::Pressure&) const { return nullptr; }
  const char* operator()(const pfv::PressureProfile&) const { return "a pressure profile"; }
  const char* operator()(const pfv::Flux&) const { return "an imposed flux"; }
  const char* operator()(const pfv::Periodic&) const { return "a periodic face"; }
};

} // namespace

std::optional<std::string> beyond_walls_and_pressures(const pfv::Case& problem) {
  for (const pfv::Face face : pfv::all_faces)
    if (const char* what = std::visit(Beyond{}, problem.faces[static_cast<std::size_t>(index(face))]))
      return fmt::format("{} on {}: it knows slip walls and faces at one pressure", what,
                         pfv::face_names[static_cast<std::size_t>(index(face))]);
  if (!problem.pressure_points.empty())
    return "a pressure at a point: it knows slip walls and faces at one pressure";
  return std::nullopt;
}

} // namespace reference
