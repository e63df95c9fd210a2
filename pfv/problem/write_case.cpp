#include "pfv/problem/write_case.hpp"

#include "pfv/problem/text.hpp"

#include <fmt/format.h>

namespace pfv {

namespace {

std::string toml_string(std::string_view text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\')
      result += {'\\', c};
    else if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f)
      result += fmt::format("\\u{:04X}", static_cast<unsigned char>(c));
    else
      result += c;
  }
  return result + '"';
}

std::string list(const Vec3& vector) {
  return fmt::format("[{}]", shortest(vector, ", "));
}

struct ConditionText {
  std::string operator()(const SlipWall&) const { return "\"slip\""; }
  std::string operator()(const Pressure& pressure) const {
    const char* tangential = pressure.tangential == Tangential::free ? ", tangential = \"free\"" : "";
    return fmt::format("{{ pressure = {}{} }}", shortest(pressure.value), tangential);
  }
  std::string operator()(const PressureProfile& profile) const {
    std::string points;
    for (const auto& [position, pressure] : profile.points)
      points += fmt::format("{}[{}, {}]", points.empty() ? "" : ", ", shortest(position), shortest(pressure));
    return fmt::format("{{ pressure = [{}], along = \"{}\" }}", points, axis_names[index(profile.along)]);
  }
  std::string operator()(const Flux& flux) const { return fmt::format("{{ flux = {} }}", shortest(flux.value)); }
  std::string operator()(const Periodic& periodic) const {
    return fmt::format("{{ periodic = {} }}", shortest(periodic.gradient));
  }
};

} // namespace

std::string question_text(const Case& problem) {
  const auto& [box, spheres] = problem.packing;
  std::string text = fmt::format("[packing]\nbox = [{}, {}]\nspheres = [\n", list(box.lower), list(box.upper));
  for (const auto& [centre, radius] : spheres)
    text += fmt::format("  [{}, {}],\n", shortest(centre, ", "), shortest(radius));
  text += fmt::format("]\n\n[fluid]\nviscosity = {}\n\n[faces]\n", shortest(problem.fluid.viscosity));
  for (const Face face : all_faces)
    text += fmt::format("{} = {}\n", face_names[index(face)], std::visit(ConditionText{}, problem.faces[index(face)]));
  if (problem.buoyancy)
    text += fmt::format("\n[buoyancy]\nfluid_density = {}\ngravity = {}\n", shortest(problem.buoyancy->fluid_density),
                        list(problem.buoyancy->gravity));
  for (const auto& [position, pressure] : problem.pressure_points)
    text += fmt::format("\n[[pressure_points]]\nposition = {}\npressure = {}\n", list(position), shortest(pressure));
  return text;
}

std::string to_toml(const Case& problem) {
  return fmt::format("name = {}\n\n{}", toml_string(problem.name), question_text(problem));
}

} // namespace pfv
