#include "reference/openfoam/traction.hpp"

namespace reference::openfoam {

namespace {

// What a wall's traction is made of, at one face of it.
struct WallFace {
  pfv::Vec3 normal; // of unit length, out of the fluid
  double area;      // m^2
  double pressure;  // Pa
  pfv::Vec3 shear;  // Pa, -mu du/dn if the velocity falls to zero at the wall
};

template <class Visit>
void for_each_face(const FoamMesh& mesh, const MeshPatch& patch, const FlowFields& fields, const Units& units,
                   Visit visit) {
  for (std::size_t face = patch.first; face < patch.first + patch.faces; ++face) {
    const std::size_t cell = mesh.owner[face];
    const pfv::Vec3 area = mesh.area(face);
    const pfv::Vec3 normal = area.normalized();
    const double distance = normal.dot(mesh.centre(face) - mesh.cell_centres[cell]);
    visit(WallFace{normal, area.norm() * units.length * units.length,
                   units.lower_pressure + units.pressure * fields.pressure[cell],
                   Units::viscosity * units.pressure * fields.velocity[cell] / distance});
  }
}

} // namespace

Traction on_wall(const FoamMesh& mesh, const MeshPatch& patch, const FlowFields& fields, const Units& units) {
  Traction sum;
  for_each_face(mesh, patch, fields, units, [&](const WallFace& face) {
    sum.force += face.area * (face.pressure * face.normal + face.shear);
    sum.shear += face.area * face.shear;
    sum.area += face.area;
    sum.mean_pressure += face.area * face.pressure;
  });
  if (sum.area > 0)
    sum.mean_pressure /= sum.area;
  return sum;
}

pfv::Vec3 on_slip_wall(const FoamMesh& mesh, const MeshPatch& patch, const FlowFields& fields, const Units& units) {
  pfv::Vec3 force = pfv::Vec3::Zero();
  for_each_face(mesh, patch, fields, units, [&](const WallFace& face) {
    force += face.area * (face.pressure + 2 * face.shear.dot(face.normal)) * face.normal;
  });
  return force;
}

} // namespace reference::openfoam
