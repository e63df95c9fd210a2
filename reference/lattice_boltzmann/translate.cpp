#include "reference/lattice_boltzmann/translate.hpp"

#include "reference/cut_spheres.hpp"
#include "reference/lattice_boltzmann/pore_width.hpp"

#include <cmath>
#include <fmt/format.h>

namespace reference::lattice_boltzmann {

namespace {

using pfv::Vec3;

// The mean pressure: linear along the axis of the flow, constant across it. The flow is asked for the rest.
struct MeanPressure {
  int axis;
  double lower;    // Pa, on the lower face of the box
  double gradient; // Pa/m
  double origin;   // m

  double at(const Vec3& point) const { return lower + gradient * (point[axis] - origin); }
};

MeanPressure mean_pressure(const pfv::Case& problem) {
  const auto setup = pfv::permeability_setup(problem).value();
  const auto& below = problem.faces[static_cast<std::size_t>(pfv::index(pfv::lower_face(setup.axis)))];
  const auto* open = std::get_if<pfv::Pressure>(&below);
  const int axis = pfv::index(setup.axis);
  return {axis, open ? open->value : 0, *setup.pressure_drop / setup.length, problem.packing.box.lower[axis]};
}

Beyond beyond_faces(const pfv::FaceCondition& face) {
  return std::holds_alternative<pfv::Periodic>(face)   ? Beyond::repeats
         : std::holds_alternative<pfv::SlipWall>(face) ? Beyond::is_mirrored
                                                       : Beyond::is_opposed;
}

bool lets_slide(const pfv::FaceCondition& face) {
  const auto* open = std::get_if<pfv::Pressure>(&face);
  return open && open->tangential == pfv::Tangential::free;
}

// The mean pressure pushes each sphere like the fluid that it displaces, and the part of one cut by a slip wall also
// misses the pressure on the disc.
std::vector<Vec3> forces_in_si(const pfv::Case& problem, const VoxelGrid& grid, const FlowReply& reply,
                               const MeanPressure& mean) {
  const double voxel = std::pow(grid.size, 3);
  std::vector<Vec3> forces;
  for (std::size_t k = 0; k < reply.forces.size(); ++k) {
    const pfv::Sphere& sphere = problem.packing.spheres[k];
    Vec3 force = -mean.gradient * voxel * reply.forces[k];
    force[mean.axis] -= mean.gradient * voxel * reply.solid_voxels[k];
    for (const pfv::Face face : pfv::all_faces)
      if (std::holds_alternative<pfv::SlipWall>(problem.faces[static_cast<std::size_t>(pfv::index(face))]))
        force += mean.at(sphere.centre) * cut_area(sphere, face, problem.packing.box) * pfv::outward_normal(face);
    forces.push_back(force);
  }
  std::array<Vec3, 6> on_faces;
  on_faces.fill(Vec3::Zero());
  give_normal_parts_to_slip_walls(problem, forces, on_faces);
  return forces;
}

} // namespace

std::optional<std::string> beyond_lattice(const pfv::Case& problem) {
  if (!problem.pressure_points.empty())
    return "a pressure at a point: it knows walls, periodic faces and two opposite faces at one pressure each";
  for (const pfv::Face face : pfv::all_faces)
    if (lets_slide(problem.faces[static_cast<std::size_t>(pfv::index(face))]))
      return fmt::format("free tangential flow along {}: its pressure faces are planes of antisymmetry",
                         pfv::face_names[static_cast<std::size_t>(pfv::index(face))]);
  const auto setup = pfv::permeability_setup(problem);
  if (!setup || !setup->pressure_drop)
    return "needs different pressures on two opposite faces, or a mean gradient along a periodic axis, and slip walls "
           "or periodic faces around";
  if (const VoxelGrid grid = voxel_grid(problem.packing, 1); grid.misfit > largest_misfit)
    return fmt::format("cubic voxels misfit the sides of the box by {:.2g}, more than {:g}", grid.misfit,
                       largest_misfit);
  return std::nullopt;
}

FlowQuestion question_of(const pfv::Case& problem, const VoxelGrid& grid, const Probes& probes) {
  const auto& box = problem.packing.box;
  const Vec3 scale = Vec3(grid.voxels[0], grid.voxels[1], grid.voxels[2]).cwiseQuotient(box.size());
  const auto in_voxels = [&](const Vec3& point) -> Vec3 { return (point - box.lower).cwiseProduct(scale); };
  FlowQuestion question;
  question.voxels = grid.voxels;
  for (std::size_t a = 0; a < 3; ++a)
    question.beyond[a] = beyond_faces(problem.faces[2 * a]);
  question.axis = mean_pressure(problem).axis;
  for (const auto& [centre, radius] : problem.packing.spheres)
    question.spheres.push_back({in_voxels(centre), radius / grid.size});
  question.viscosity = void_measures(problem, grid).quickest_viscosity();
  for (const Vec3& point : probes.points)
    question.points.push_back(in_voxels(point));
  for (const auto& facet : probes.facets) {
    question.facets.emplace_back();
    for (const Vec3& corner : facet)
      question.facets.back().push_back(in_voxels(corner));
  }
  return question;
}

Answer answer_in_si(const pfv::Case& problem, const VoxelGrid& grid, const FlowQuestion& question,
                    const FlowReply& reply, const Probes& probes) {
  const auto setup = pfv::permeability_setup(problem).value();
  const MeanPressure mean = mean_pressure(problem);
  // A force of 1 in lattice units is minus the mean gradient: it drives downwards when the upper pressure is higher.
  const double velocity = -mean.gradient * grid.size * grid.size / problem.fluid.viscosity * question.viscosity;
  const double flux = velocity * reply.velocity * setup.area;
  Answer answer;
  answer.permeability = question.viscosity * reply.velocity * grid.size * grid.size;
  answer.face_flux[static_cast<std::size_t>(pfv::index(pfv::lower_face(setup.axis)))] = -flux;
  answer.face_flux[static_cast<std::size_t>(pfv::index(pfv::upper_face(setup.axis)))] = flux;
  answer.porosity = static_cast<double>(reply.fluid_voxels) / grid.count();
  answer.sphere_forces = forces_in_si(problem, grid, reply, mean);
  if (!probes.points.empty()) {
    answer.point_pressures.emplace();
    for (std::size_t i = 0; i < probes.points.size(); ++i)
      answer.point_pressures->push_back(mean.at(probes.points[i]) - mean.gradient * grid.size * reply.pressures[i]);
  }
  if (!probes.facets.empty()) {
    answer.facet_fluxes.emplace();
    for (const double lattice_flux : reply.fluxes)
      answer.facet_fluxes->push_back(velocity * grid.size * grid.size * lattice_flux);
  }
  return answer;
}

} // namespace reference::lattice_boltzmann
