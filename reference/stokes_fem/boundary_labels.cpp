#include "reference/stokes_fem/boundary_labels.hpp"

#include "pfv/problem/error.hpp"

#include <algorithm>
#include <charconv>
#include <fstream>
#include <iomanip>
#include <optional>
#include <string_view>

namespace reference::stokes_fem {

namespace {

std::optional<std::size_t> index_in(std::string_view text, std::size_t spheres) {
  std::size_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || value >= spheres)
    return std::nullopt;
  return value;
}

std::optional<pfv::Face> face_named(std::string_view text) {
  const auto found = std::ranges::find(pfv::face_names, text);
  if (found == pfv::face_names.end())
    return std::nullopt;
  return pfv::all_faces[static_cast<std::size_t>(found - pfv::face_names.begin())];
}

std::optional<BoundaryLabel> bridge_named(std::string_view ends, std::size_t spheres) {
  const std::size_t cut = ends.find('_');
  if (cut == std::string_view::npos)
    return std::nullopt;
  const auto first = index_in(ends.substr(0, cut), spheres);
  if (!first)
    return std::nullopt;
  if (const auto face = face_named(ends.substr(cut + 1)))
    return Bridge{*first, *face};
  if (const auto second = index_in(ends.substr(cut + 1), spheres))
    return Bridge{*first, *second};
  return std::nullopt;
}

std::optional<BoundaryLabel> find_label(std::string_view group, std::size_t spheres) {
  constexpr std::string_view sphere = "sphere_";
  constexpr std::string_view bridge = "bridge_";
  if (const auto face = face_named(group))
    return BoxFace{*face};
  if (group.starts_with(sphere))
    if (const auto index = index_in(group.substr(sphere.size()), spheres))
      return SphereSurface{*index};
  if (group.starts_with(bridge))
    return bridge_named(group.substr(bridge.size()), spheres);
  return std::nullopt;
}

} // namespace

BoundaryLabel label_of(const std::string& group, std::size_t spheres) {
  if (const auto label = find_label(group, spheres))
    return *label;
  throw pfv::SolveError("the mesh names a surface '" + group +
                        "'; it can be x_min ... z_max, sphere_K, bridge_I_J or bridge_K_x_min, with indices below " +
                        std::to_string(spheres));
}

BoundaryLabels read_labels(const std::filesystem::path& mesh, std::size_t spheres) {
  std::ifstream in(mesh);
  std::string line;
  while (std::getline(in, line) && !line.starts_with("$PhysicalNames"))
    ;
  std::size_t groups = 0;
  if (!(in >> groups))
    throw pfv::SolveError("no $PhysicalNames in the mesh '" + mesh.string() + "'");
  BoundaryLabels labels;
  for (std::size_t group = 0; group < groups; ++group) {
    int dimension = 0;
    unsigned id = 0;
    std::string name;
    if (!(in >> dimension >> id >> std::quoted(name)))
      throw pfv::SolveError("$PhysicalNames of the mesh '" + mesh.string() + "' ends early");
    if (dimension == 2)
      labels.emplace(id, label_of(name, spheres));
  }
  return labels;
}

} // namespace reference::stokes_fem
