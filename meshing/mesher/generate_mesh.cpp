#include "meshing/mesher/generate_mesh.hpp"

#include "meshing/contact_bridges.hpp"
#include "meshing/dented_cells.hpp"
#include "meshing/element_size.hpp"
#include "meshing/linear_mesh.hpp"
#include "meshing/measure_mesh.hpp"
#include "meshing/mesher/void_geometry.hpp"
#include "meshing/periodic_faces.hpp"
#include "pfv/problem/face.hpp"

#include <algorithm>
#include <cstdint>
#include <fmt/format.h>
#include <gmsh.h>
#include <map>
#include <stdexcept>
#include <string>

namespace mesher {

namespace {

void set_options() {
  using gmsh::option::setNumber;
  setNumber("General.Terminal", 1);
  setNumber("General.NumThreads", 1);
  setNumber("General.Verbosity", 4);
  // The callback alone says how fine.
  setNumber("Mesh.CharacteristicLengthFromPoints", 0);
  setNumber("Mesh.CharacteristicLengthFromCurvature", 0);
  setNumber("Mesh.CharacteristicLengthExtendFromBoundary", 0);
  setNumber("Mesh.ElementOrder", 1);
  setNumber("Mesh.RandomSeed", 1);
  setNumber("Mesh.Algorithm", 6);   // frontal-Delaunay
  setNumber("Mesh.Algorithm3D", 1); // Delaunay
  setNumber("Mesh.Optimize", 1);
}

/// Nodes of gmsh, whose tags have gaps, numbered from 0 as they are used.
class Nodes {
public:
  Nodes() {
    std::vector<double> parametric;
    gmsh::model::mesh::getNodes(tags_, coordinates_, parametric);
    for (std::size_t i = 0; i < tags_.size(); ++i)
      place_[tags_[i]] = i;
  }
  int number(std::size_t tag) {
    const auto [entry, is_new] = number_.emplace(tag, static_cast<int>(used_.size()));
    if (is_new) {
      const double* c = coordinates_.data() + 3 * place_.at(tag);
      used_.emplace_back(c[0], c[1], c[2]);
    }
    return entry->second;
  }
  const std::vector<pfv::Vec3>& used() const { return used_; }

private:
  std::vector<std::size_t> tags_;
  std::vector<double> coordinates_;
  std::map<std::size_t, std::size_t> place_;
  std::map<std::size_t, int> number_;
  std::vector<pfv::Vec3> used_;
};

/// The simplices of one entity: triangles (gmsh type 2) of a surface or tetrahedra (type 4) of a volume.
template <std::size_t Corners>
void append(int dimension, int entity, Nodes& nodes, std::vector<std::array<int, Corners>>& simplices) {
  constexpr int type = Corners == 3 ? 2 : 4;
  std::vector<std::size_t> elements, corners;
  gmsh::model::mesh::getElementsByType(type, elements, corners, entity);
  if (elements.empty())
    throw std::runtime_error("gmsh left entity " + std::to_string(entity) + " of dimension " +
                             std::to_string(dimension) + " without elements");
  for (std::size_t i = 0; i < corners.size(); i += Corners) {
    auto& simplex = simplices.emplace_back();
    std::transform(corners.begin() + static_cast<std::ptrdiff_t>(i),
                   corners.begin() + static_cast<std::ptrdiff_t>(i + Corners), simplex.begin(),
                   [&](std::size_t tag) { return nodes.number(tag); });
  }
}

meshing::LinearMesh mesh_of(const VoidGeometry& geometry) {
  meshing::LinearMesh mesh;
  Nodes nodes;
  for (const int volume : geometry.volumes)
    append(3, volume, nodes, mesh.tetrahedra);
  for (const auto& [name, surfaces] : geometry.surfaces) {
    std::vector<std::array<int, 3>> triangles;
    for (const int surface : surfaces)
      append(2, surface, nodes, triangles);
    for (const auto& corners : triangles)
      mesh.triangles.push_back({corners, static_cast<int>(mesh.surfaces.size())});
    mesh.surfaces.push_back(name);
  }
  mesh.nodes = nodes.used();
  return mesh;
}

struct Result {
  meshing::LinearMesh mesh;
  meshing::MeshQuality quality;
};

/// The packing in units of its mean radius, its box at the origin: OpenCASCADE's tolerances are lengths.
pfv::Packing in_radii(const pfv::Packing& packing, double radius) {
  pfv::Packing result;
  result.box = {pfv::Vec3::Zero(), packing.box.size() / radius};
  for (const auto& [centre, r] : packing.spheres)
    result.spheres.push_back({(centre - packing.box.lower) / radius, r / radius});
  return result;
}

/// Back to metres, with the nodes on faces of the box exactly there.
void place_in_box(meshing::LinearMesh& mesh, const pfv::Box& box, double radius) {
  for (pfv::Vec3& node : mesh.nodes)
    node = box.lower + radius * node;
  for (const auto& [nodes, surface] : mesh.triangles)
    for (const pfv::Face face : pfv::all_faces)
      if (mesh.surfaces[static_cast<std::size_t>(surface)] == pfv::face_names[pfv::index(face)])
        for (const int node : nodes) {
          const int axis = pfv::index(pfv::axis_of(face));
          mesh.nodes[static_cast<std::size_t>(node)][axis] = (pfv::is_upper(face) ? box.upper : box.lower)[axis];
        }
}

Result mesh_once(const pfv::Packing& packing, const pfv::PeriodicAxes& periodic, double mesh_size, double bridge_radius,
                 std::uint64_t attempt) {
  double radius = 0; // mean
  for (const pfv::Sphere& sphere : packing.spheres)
    radius += sphere.radius / static_cast<double>(packing.spheres.size());
  const pfv::Packing scaled = in_radii(packing, radius);
  const meshing::ImagedPacking imaged = meshing::with_images(scaled, periodic);
  const auto geometry = build_void(imaged, meshing::contact_bridges(imaged.packing, bridge_radius, periodic), attempt);
  const meshing::ElementSize size(scaled, mesh_size, bridge_radius, periodic);
  gmsh::model::mesh::setSizeCallback([&](int, int, double x, double y, double z) { return size(pfv::Vec3(x, y, z)); });
  gmsh::model::mesh::generate(3);

  Result result{meshing::without_dented_cells(mesh_of(geometry)), {}};
  place_in_box(result.mesh, packing.box, radius);
  meshing::align_periodic_faces(result.mesh, packing.box, periodic, 1e-5 * radius);
  meshing::check(result.mesh);
  result.quality = meshing::measure_mesh(result.mesh, meshing::with_images(packing, periodic).packing);
  result.quality.parts = geometry.volumes.size();
  result.quality.enclosed_parts = geometry.enclosed;
  return result;
}

} // namespace

meshing::MeshQuality generate_mesh(const pfv::Packing& packing, const pfv::PeriodicAxes& periodic, double mesh_size,
                                   double bridge_radius, const std::string& file) {
  set_options();
  constexpr std::uint64_t attempts = 8;
  for (std::uint64_t attempt = 1;; ++attempt) {
    std::string reason;
    try {
      const auto [mesh, quality] = mesh_once(packing, periodic, mesh_size, bridge_radius, attempt);
      meshing::write_msh(mesh, file);
      return quality;
    } catch (const std::exception& error) {
      reason = error.what();
    } catch (const std::string& message) { // what gmsh throws
      reason = "gmsh: " + message;
    } catch (int code) { // what gmsh throws elsewhere
      reason = fmt::format("gmsh: error {}", code);
    }
    if (attempt == attempts)
      throw std::runtime_error(fmt::format("{} (the last of {} attempts)", reason, attempts));
    fmt::print("attempt {}: {}\n", attempt, reason);
  }
}

} // namespace mesher
