#include "reference/openfoam/patches.hpp"

#include "pfv/problem/error.hpp"

#include <charconv>
#include <optional>
#include <string_view>

namespace reference::openfoam {

namespace {

std::optional<std::size_t> whole_number(std::string_view text) {
  std::size_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (text.empty() || error != std::errc{} || end != text.data() + text.size())
    return std::nullopt;
  return value;
}

std::optional<pfv::Face> face_named(std::string_view name) {
  for (const pfv::Face face : pfv::all_faces)
    if (pfv::face_names[static_cast<std::size_t>(pfv::index(face))] == name)
      return face;
  return std::nullopt;
}

std::optional<Patch> bridge_between(std::string_view ends) {
  const auto underscore = ends.find('_');
  if (underscore == std::string_view::npos)
    return std::nullopt;
  const auto first = whole_number(ends.substr(0, underscore));
  const auto other = ends.substr(underscore + 1);
  if (!first)
    return std::nullopt;
  if (const auto second = whole_number(other))
    return PairBridge{*first, *second};
  if (const auto face = face_named(other))
    return WallBridge{*first, *face};
  return std::nullopt;
}

} // namespace

Patch patch_named(const std::string& name) {
  const std::string_view text = name;
  if (const auto face = face_named(text))
    return *face;
  if (text.starts_with("sphere_"))
    if (const auto sphere = whole_number(text.substr(7)))
      return SphereSurface{*sphere};
  if (text.starts_with("bridge_"))
    if (const auto bridge = bridge_between(text.substr(7)))
      return *bridge;
  throw pfv::SolveError("the mesh has a surface '" + name +
                        "' that is neither a face of the box nor a sphere nor a bridge");
}

} // namespace reference::openfoam
