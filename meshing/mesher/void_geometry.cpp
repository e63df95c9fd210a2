#include "meshing/mesher/void_geometry.hpp"

#include "meshing/exact_void.hpp"
#include "meshing/mesher/seams.hpp"
#include "meshing/mesher/surface_names.hpp"

#include <algorithm>
#include <cstdint>
#include <fmt/format.h>
#include <gmsh.h>
#include <numbers>
#include <stdexcept>

namespace mesher {

namespace {

namespace occ = gmsh::model::occ;

void turn(int volume, const pfv::Vec3& about, const Eigen::Quaterniond& by) {
  const Eigen::AngleAxisd rotation(by);
  const pfv::Vec3& axis = rotation.axis();
  occ::rotate({{3, volume}}, about.x(), about.y(), about.z(), axis.x(), axis.y(), axis.z(), rotation.angle());
}

/// Those that reach into the box.
gmsh::vectorpair add_spheres(const pfv::Packing& packing, const std::vector<Eigen::Quaterniond>& turns) {
  gmsh::vectorpair volumes;
  for (std::size_t k = 0; k < packing.spheres.size(); ++k) {
    const auto& [centre, radius] = packing.spheres[k];
    if (meshing::distance_to_box(packing.box, centre) > (1 - 1e-6) * radius)
      continue;
    const int volume = occ::addSphere(centre.x(), centre.y(), centre.z(), radius);
    turn(volume, centre, turns[k]);
    volumes.emplace_back(3, volume);
  }
  return volumes;
}

gmsh::vectorpair add_bridges(const std::vector<meshing::Bridge>& bridges,
                             const std::vector<Eigen::Quaterniond>& turns) {
  gmsh::vectorpair volumes;
  for (std::size_t b = 0; b < bridges.size(); ++b) {
    const auto& [name, from, to, radius] = bridges[b];
    const int volume = occ::addCylinder(from.x(), from.y(), from.z(), 0, 0, (to - from).norm(), radius);
    turn(volume, from, turns[b]);
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

/// Of OpenCASCADE's solids, summed.
double volume_of(const gmsh::vectorpair& solids) {
  double total = 0;
  for (const auto& [dimension, volume] : solids) {
    double mass = 0;
    occ::getMass(dimension, volume, mass);
    total += mass;
  }
  return total;
}

/// A boolean that forgets a sphere or loses a piece does not say so, but the volume does. What bridges take from the
/// fluid is less than a tenth of their own volume, which is mostly inside the spheres.
void check_volume(double volume, const pfv::Packing& packing, const std::vector<meshing::Bridge>& bridges) {
  const double exact = meshing::exact_void(packing).volume;
  double allowance = 0;
  for (const meshing::Bridge& bridge : bridges)
    allowance += 0.1 * std::numbers::pi * bridge.radius * bridge.radius * (bridge.to - bridge.from).norm();
  const double round_off = 1e-6 * packing.box.volume();
  if (volume > exact + round_off || volume < exact - allowance - round_off)
    throw std::runtime_error(fmt::format("OpenCASCADE left a volume of {:g} where the void has {:g}", volume, exact));
}

struct SurfaceMeasure {
  pfv::Vec3 centre;
  double area;
};

SurfaceMeasure measure(int surface) {
  SurfaceMeasure made{};
  occ::getCenterOfMass(2, surface, made.centre.x(), made.centre.y(), made.centre.z());
  occ::getMass(2, surface, made.area);
  return made;
}

/// Tells gmsh to mesh the upper of two faces like the lower one. The geometry is in units of the mean radius.
void make_periodic(const VoidGeometry& geometry, pfv::Axis axis, double length) {
  constexpr double tolerance = 1e-5;
  const auto tags = [&](pfv::Face face) {
    const auto found = geometry.surfaces.find(std::string(pfv::face_names[static_cast<std::size_t>(pfv::index(face))]));
    return found == geometry.surfaces.end() ? std::vector<int>{} : found->second;
  };
  const auto lower = tags(pfv::lower_face(axis));
  const auto upper = tags(pfv::upper_face(axis));
  const pfv::Vec3 shift = length * pfv::Vec3::Unit(pfv::index(axis));
  const std::vector<double> translation{1, 0, 0, shift.x(), 0, 1, 0, shift.y(), 0, 0, 1, shift.z(), 0, 0, 0, 1};
  std::size_t matched = 0;
  for (const int master : lower)
    for (const int slave : upper) {
      const SurfaceMeasure a = measure(master);
      const SurfaceMeasure b = measure(slave);
      if ((b.centre - a.centre - shift).norm() > tolerance || std::abs(b.area - a.area) > tolerance)
        continue;
      gmsh::model::mesh::setPeriodic(2, {slave}, {master}, translation);
      ++matched;
    }
  if (matched != lower.size() || matched != upper.size())
    throw std::runtime_error(fmt::format("the {} surfaces on {} do not repeat on the opposite face", lower.size(),
                                         pfv::face_names[static_cast<std::size_t>(pfv::index(pfv::lower_face(axis)))]));
}

} // namespace

VoidGeometry build_void(const meshing::ImagedPacking& imaged, const std::vector<meshing::Bridge>& bridges,
                        std::uint64_t attempt) {
  gmsh::clear();
  gmsh::model::add("void");
  const pfv::Packing& packing = imaged.packing;
  const Turns turns = turns_of_seams(imaged, bridges, attempt);
  const pfv::Vec3& corner = packing.box.lower;
  const pfv::Vec3 size = packing.box.size();
  const gmsh::vectorpair box{{3, occ::addBox(corner.x(), corner.y(), corner.z(), size.x(), size.y(), size.z())}};
  // Bridges first: then no two spheres touch in what is left to cut.
  const auto fluid = cut(cut(box, add_bridges(bridges, turns.bridges)), add_spheres(packing, turns.spheres));
  occ::synchronize();
  check_volume(volume_of(fluid), packing, bridges);

  VoidGeometry result;
  for (const auto& [dimension, volume] : fluid) {
    gmsh::vectorpair boundary;
    gmsh::model::getBoundary({{dimension, volume}}, boundary, false, false);
    std::map<std::string, std::vector<int>> surfaces;
    for (const auto& [surface_dimension, surface] : boundary)
      surfaces[name_of_surface(points_on(surface), packing, bridges)].push_back(surface);
    if (std::ranges::none_of(surfaces, is_box_face, [](const auto& surface) { return surface.first; })) {
      ++result.enclosed;
      continue;
    }
    result.volumes.push_back(volume);
    for (const auto& [name, tags] : surfaces)
      result.surfaces[name].insert(result.surfaces[name].end(), tags.begin(), tags.end());
  }
  if (result.volumes.empty())
    throw std::runtime_error("no volume of fluid touches a face of the box");
  for (const pfv::Axis axis : {pfv::Axis::x, pfv::Axis::y, pfv::Axis::z})
    if (imaged.periodic[static_cast<std::size_t>(pfv::index(axis))])
      make_periodic(result, axis, size[pfv::index(axis)]);
  return result;
}

} // namespace mesher
