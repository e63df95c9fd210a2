#include "meshing/mesh_quality.hpp"

#include <nlohmann/json.hpp>
#include <stdexcept>

namespace meshing {

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(MeshQuality, nodes, tetrahedra, volume, exact_volume, volume_error, surface,
                                   exact_surface, surface_error, bridges, parts, enclosed_parts, worst_quality)

std::string to_json(const MeshQuality& quality) {
  return nlohmann::json(quality).dump(2);
}

MeshQuality mesh_quality_from_json(const std::string& text) {
  try {
    return nlohmann::json::parse(text).get<MeshQuality>();
  } catch (const nlohmann::json::exception& error) {
    throw std::runtime_error(std::string("not a mesh quality: ") + error.what());
  }
}

} // namespace meshing
