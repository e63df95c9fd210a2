#include "pfv/problem/error.hpp"
#include "reference/stokes_fem/discretisation.hpp"
#include "reference/stokes_fem/identified_nodes.hpp"

#include <deal.II/base/config.h>
#include <deal.II/base/multithread_info.h>
#include <deal.II/grid/grid_in.h>
#include <deal.II/grid/grid_tools.h>

#include <fstream>

namespace reference::stokes_fem {

namespace {

void read(const std::filesystem::path& file, dealii::Triangulation<3>& mesh) {
  std::ifstream in(file);
  dealii::GridIn<3> reader(mesh);
  try {
    reader.read_msh(in);
  } catch (const dealii::ExceptionBase& error) {
    throw pfv::SolveError("deal.II cannot read the mesh '" + file.string() + "': " + error.get_exc_name());
  }
  if (!mesh.all_reference_cells_are_simplex())
    throw pfv::SolveError("the mesh '" + file.string() + "' has cells that are not tetrahedra");
}

void check_labelled(const Discretisation& discretisation, const std::filesystem::path& file) {
  for (const unsigned id : discretisation.mesh.get_boundary_ids())
    if (!discretisation.label_index.contains(id))
      throw pfv::SolveError("the mesh '" + file.string() + "' has boundary triangles in a group without a name (" +
                            std::to_string(id) + ")");
}

} // namespace

std::shared_ptr<Discretisation> discretise(const std::filesystem::path& mesh, const pfv::Case& unit,
                                           const pfv::Vec3& origin, double length, double bridge_radius) {
  dealii::MultithreadInfo::set_thread_limit(1);
  auto made = std::make_shared<Discretisation>();
  const BoundaryLabels labels = read_labels(mesh, unit.packing.spheres.size());
  for (const auto& [id, label] : labels) {
    made->label_index[id] = static_cast<int>(made->labels.size());
    made->labels.push_back(label);
  }
  read(mesh, made->mesh);
  check_labelled(*made, mesh);
  const dealii::Point<3> corner(origin[0], origin[1], origin[2]);
  dealii::GridTools::transform([&](const dealii::Point<3>& x) { return dealii::Point<3>((x - corner) / length); },
                               made->mesh);
  const pfv::PeriodicAxes periodic = periodic_axes(unit.faces);
  const auto surface = [&](unsigned id) { return exact_surface(labels.at(id), unit.packing, bridge_radius); };
  made->mapping = std::make_unique<CurvedMapping>(std::make_shared<CurvedEdges>(
      curve_edges(made->mesh, surface, identified_vertices(*made, unit.packing.box, periodic))));
  made->velocity.reinit(made->mesh);
  made->velocity.distribute_dofs(made->quadratic);
  made->pressure.reinit(made->mesh);
  made->pressure.distribute_dofs(made->linear);
  identify_nodes(*made, unit.packing.box, periodic);
  return made;
}

MeshFacts facts(const Discretisation& discretisation) {
  const CurvedEdges& edges = discretisation.mapping->edges();
  return {discretisation.mesh.n_active_cells(), edges.curved_cells, edges.straightened_cells,
          discretisation.velocity_nodes, discretisation.pressure_nodes};
}

std::string element_library() {
  return "deal.II " DEAL_II_PACKAGE_VERSION;
}

} // namespace reference::stokes_fem
