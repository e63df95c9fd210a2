#include "meshing/mesher/void_geometry.hpp"

#include "meshing/mesher/surface_names.hpp"

#include <array>
#include <cmath>
#include <gmsh.h>
#include <numbers>
#include <random>
#include <stdexcept>

namespace mesher {

namespace {

namespace occ = gmsh::model::occ;

/// Angles and directions that are the same on every machine.
class Directions {
public:
  double angle() { return 2 * std::numbers::pi * uniform(); }
  pfv::Vec3 direction() {
    const double z = 2 * uniform() - 1;
    const double turn = angle();
    const double across = std::sqrt(1 - z * z);
    return {across * std::cos(turn), across * std::sin(turn), z};
  }

private:
  double uniform() { return static_cast<double>(random_() >> 11) * 0x1p-53; }
  std::mt19937_64 random_{20110101};
};

void rotate(int volume, const pfv::Vec3& centre, const pfv::Vec3& axis, double angle) {
  occ::rotate({{3, volume}}, centre.x(), centre.y(), centre.z(), axis.x(), axis.y(), axis.z(), angle);
}

/// Every sphere turned its own way: OpenCASCADE fails where poles and seams of many spheres line up with each other or
/// with the box.
gmsh::vectorpair add_spheres(const std::vector<pfv::Sphere>& spheres, Directions& random) {
  gmsh::vectorpair volumes;
  for (const auto& [centre, radius] : spheres) {
    const int volume = occ::addSphere(centre.x(), centre.y(), centre.z(), radius);
    rotate(volume, centre, random.direction(), random.angle());
    volumes.emplace_back(3, volume);
  }
  return volumes;
}

gmsh::vectorpair add_bridges(const std::vector<meshing::Bridge>& bridges, Directions& random) {
  gmsh::vectorpair volumes;
  for (const meshing::Bridge& bridge : bridges) {
    const pfv::Vec3 along = bridge.to - bridge.from;
    const int volume = occ::addCylinder(bridge.from.x(), bridge.from.y(), bridge.from.z(), along.x(), along.y(),
                                        along.z(), bridge.radius);
    rotate(volume, bridge.from, along, random.angle());
    volumes.emplace_back(3, volume);
  }
  return volumes;
}

gmsh::vectorpair cut(const gmsh::vectorpair& solid, const gmsh::vectorpair& tools) {
  if (tools.empty())
    return solid;
  gmsh::vectorpair result;
  std::vector<gmsh::vectorpair> map;
  occ::cut(solid, tools, result, map);
  if (result.empty())
    throw std::runtime_error("OpenCASCADE left no volume of fluid");
  return result;
}

/// Points all over the surface that a trimmed surface is a part of, inside its parametric bounds.
std::vector<pfv::Vec3> points_on(int surface) {
  std::vector<double> lower, upper;
  gmsh::model::getParametrizationBounds(2, surface, lower, upper);
  std::vector<double> parameters;
  constexpr int n = 5;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      parameters.push_back(lower.at(0) + (upper.at(0) - lower.at(0)) * (i + 0.5) / n);
      parameters.push_back(lower.at(1) + (upper.at(1) - lower.at(1)) * (j + 0.5) / n);
    }
  std::vector<double> coordinates;
  gmsh::model::getValue(2, surface, parameters, coordinates);
  std::vector<pfv::Vec3> points;
  for (std::size_t i = 0; i + 2 < coordinates.size(); i += 3)
    points.emplace_back(coordinates[i], coordinates[i + 1], coordinates[i + 2]);
  return points;
}

bool is_box_face(const std::string& name) {
  return name.find('_') == 1;
} // x_min, not sphere_3 or bridge_1_2

} // namespace

VoidGeometry build_void(const pfv::Packing& packing, const std::vector<meshing::Bridge>& bridges) {
  Directions random;
  const pfv::Vec3& corner = packing.box.lower;
  const pfv::Vec3 size = packing.box.size();
  const gmsh::vectorpair box{{3, occ::addBox(corner.x(), corner.y(), corner.z(), size.x(), size.y(), size.z())}};
  const auto fluid = cut(cut(box, add_bridges(bridges, random)), add_spheres(packing.spheres, random));
  occ::synchronize();

  VoidGeometry result;
  for (const auto& [dimension, volume] : fluid) {
    gmsh::vectorpair boundary;
    gmsh::model::getBoundary({{dimension, volume}}, boundary, false, false);
    std::map<std::string, std::vector<int>> surfaces;
    bool open = false;
    for (const auto& [surface_dimension, surface] : boundary) {
      const std::string name = name_of_surface(points_on(surface), packing, bridges);
      surfaces[name].push_back(surface);
      open = open || is_box_face(name);
    }
    if (!open) {
      ++result.enclosed;
      continue;
    }
    result.volumes.push_back(volume);
    for (const auto& [name, tags] : surfaces)
      result.surfaces[name].insert(result.surfaces[name].end(), tags.begin(), tags.end());
  }
  if (result.volumes.empty())
    throw std::runtime_error("no volume of fluid touches a face of the box");
  return result;
}

} // namespace mesher
