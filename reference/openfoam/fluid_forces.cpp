#include "reference/openfoam/fluid_forces.hpp"

#include "reference/cut_spheres.hpp"
#include "reference/openfoam/disc.hpp"
#include "reference/openfoam/traction.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numeric>

namespace reference::openfoam {

namespace {

std::size_t slot(pfv::Face face) {
  return static_cast<std::size_t>(pfv::index(face));
}

double position(pfv::Face face, const pfv::Box& box) {
  return (pfv::is_upper(face) ? box.upper : box.lower)[pfv::index(pfv::axis_of(face))];
}

double area_of(pfv::Face face, const pfv::Box& box) {
  return box.volume() / box.size()[pfv::index(pfv::axis_of(face))];
}

double area_of(const FoamMesh& mesh, const MeshPatch& patch) {
  double area = 0;
  for (std::size_t face = patch.first; face < patch.first + patch.faces; ++face)
    area += mesh.area(face).norm();
  return area;
}

class ForceSum {
public:
  ForceSum(const pfv::Case& problem, const std::vector<meshing::Bridge>& bridges)
      : problem_(problem), box_(problem.packing.box), spheres_(problem.packing.spheres), bridges_(bridges) {
    forces_.on_spheres.assign(spheres_.size(), pfv::Vec3::Zero());
    forces_.viscous = forces_.on_spheres;
    forces_.on_faces.fill(pfv::Vec3::Zero());
  }

  void add_sphere(const SphereSurface& surface, const Traction& traction) {
    forces_.on_spheres[surface.sphere] += traction.force;
    forces_.viscous[surface.sphere] += traction.shear;
  }

  void add_bridge(const PairBridge& ends, const std::string& name, const Traction& traction) {
    const pfv::Sphere& first = spheres_[ends.first];
    const pfv::Sphere& second = spheres_[ends.second];
    const pfv::Vec3 across = (second.centre - first.centre).normalized();
    const pfv::Vec3 middle = 0.5 * (first.centre + first.radius * across + second.centre - second.radius * across);
    const pfv::Vec3 cap = traction.mean_pressure * area_inside({middle, across, radius(name)}, box_) * across;
    forces_.on_spheres[ends.first] += traction.force / 2 - cap;
    forces_.on_spheres[ends.second] += traction.force / 2 + cap;
    forces_.viscous[ends.first] += traction.shear / 2;
    forces_.viscous[ends.second] += traction.shear / 2;
  }

  void add_bridge(const WallBridge& ends, const std::string& name, const Traction& traction) {
    forces_.on_spheres[ends.sphere] += traction.force;
    forces_.viscous[ends.sphere] += traction.shear;
    if (open(ends.face))
      return; // the face's own pressure acts there
    const pfv::Vec3 cap =
        traction.mean_pressure * wall_bridge_area(ends.sphere, ends.face, name) * pfv::outward_normal(ends.face);
    forces_.on_spheres[ends.sphere] -= cap;
    forces_.on_faces[slot(ends.face)] += cap;
  }

  /// `missing`: what the mesh lacks of the face's area (m^2), shared out among the spheres that cut or touch it.
  void add_pressure_face(pfv::Face face, double pressure, double missing) {
    const pfv::Vec3 normal = pfv::outward_normal(face);
    forces_.on_faces[slot(face)] += pressure * area_of(face, box_) * normal;
    std::vector<double> parts(spheres_.size());
    for (std::size_t k = 0; k < spheres_.size(); ++k)
      parts[k] = std::max(cut_area(spheres_[k], face, box_),
                          wall_bridge_area(k, face, fmt::format("bridge_{}_{}", k, pfv::face_names[slot(face)])));
    const double sum = std::accumulate(parts.begin(), parts.end(), 0.0);
    for (std::size_t k = 0; sum > 0 && k < spheres_.size(); ++k)
      forces_.on_spheres[k] -= pressure * missing * parts[k] / sum * normal;
  }

  void add_slip_wall(pfv::Face face, const pfv::Vec3& force) { forces_.on_faces[slot(face)] += force; }

  const pfv::Pressure* open(pfv::Face face) const { return std::get_if<pfv::Pressure>(&problem_.faces[slot(face)]); }

  FluidForces mirrored() const {
    FluidForces forces = forces_;
    give_normal_parts_to_slip_walls(problem_, forces.on_spheres, forces.on_faces);
    drop_normal_parts_at_slip_walls(problem_, forces.viscous);
    return forces;
  }

private:
  double radius(const std::string& bridge) const {
    const auto found = std::ranges::find(bridges_, bridge, &meshing::Bridge::name);
    return found == bridges_.end() ? 0 : found->radius;
  }

  double wall_bridge_area(std::size_t sphere, pfv::Face face, const std::string& name) const {
    const pfv::Vec3 normal = pfv::outward_normal(face);
    const double distance = std::abs(position(face, box_) - spheres_[sphere].centre[pfv::index(pfv::axis_of(face))]);
    const double r = radius(name);
    return r == 0 ? 0 : area_inside({spheres_[sphere].centre + distance * normal, normal, r}, box_);
  }

  const pfv::Case& problem_;
  const pfv::Box& box_;
  const std::vector<pfv::Sphere>& spheres_;
  const std::vector<meshing::Bridge>& bridges_;
  FluidForces forces_;
};

} // namespace

FluidForces fluid_forces(const FoamMesh& mesh, const FlowFields& fields, const pfv::Case& problem,
                         const std::vector<meshing::Bridge>& bridges) {
  const Units units = units_of(problem);
  ForceSum sum(problem, bridges);
  for (const MeshPatch& patch : mesh.patches) {
    if (const auto* face = std::get_if<pfv::Face>(&patch.part)) {
      const double meshed = area_of(mesh, patch) * units.length * units.length;
      if (const auto* open = sum.open(*face))
        sum.add_pressure_face(*face, open->value, area_of(*face, problem.packing.box) - meshed);
      else
        sum.add_slip_wall(*face, on_slip_wall(mesh, patch, fields, units));
    } else if (const auto* sphere = std::get_if<SphereSurface>(&patch.part)) {
      sum.add_sphere(*sphere, on_wall(mesh, patch, fields, units));
    } else if (const auto* pair = std::get_if<PairBridge>(&patch.part)) {
      sum.add_bridge(*pair, patch.name, on_wall(mesh, patch, fields, units));
    } else {
      sum.add_bridge(std::get<WallBridge>(patch.part), patch.name, on_wall(mesh, patch, fields, units));
    }
  }
  return sum.mirrored();
}

} // namespace reference::openfoam
