#include "reference/openfoam/traction.hpp"

namespace reference::openfoam {

Traction on_wall(const FoamMesh& mesh, const MeshPatch& patch, const FlowFields& fields, const Units& units) {
  Traction sum;
  for (std::size_t face = patch.first; face < patch.first + patch.faces; ++face) {
    const std::size_t cell = mesh.owner[face];
    const pfv::Vec3 area = mesh.area(face);
    const pfv::Vec3 normal = area.normalized();
    const double distance = normal.dot(mesh.centre(face) - mesh.cell_centres[cell]);
    const double pressure = units.lower_pressure + units.pressure * fields.pressure[cell];
    const pfv::Vec3 shear = Units::viscosity * units.pressure * fields.velocity[cell] / distance;
    const double size = area.norm() * units.length * units.length;
    sum.force += size * (pressure * normal + shear);
    sum.area += size;
    sum.mean_pressure += size * pressure;
  }
  if (sum.area > 0)
    sum.mean_pressure /= sum.area;
  return sum;
}

pfv::Vec3 on_slip_wall(const FoamMesh& mesh, const MeshPatch& patch, const FlowFields& fields, const Units& units) {
  pfv::Vec3 force = pfv::Vec3::Zero();
  for (std::size_t face = patch.first; face < patch.first + patch.faces; ++face) {
    const std::size_t cell = mesh.owner[face];
    const pfv::Vec3 area = mesh.area(face);
    const pfv::Vec3 normal = area.normalized();
    const double distance = normal.dot(mesh.centre(face) - mesh.cell_centres[cell]);
    const double pressure = units.lower_pressure + units.pressure * fields.pressure[cell];
    const double strain = Units::viscosity * units.pressure * fields.velocity[cell].dot(normal) / distance;
    force += area * units.length * units.length * (pressure + 2 * strain);
  }
  return force;
}

} // namespace reference::openfoam
