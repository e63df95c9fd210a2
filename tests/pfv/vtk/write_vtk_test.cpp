// The files as VTK's own readers see them.
#include "pfv/vtk/write_vtk.hpp"

#include "pfv/flow/fluxes.hpp"
#include "pfv/problem/generate.hpp"
#include "support/packings.hpp"
#include "support/temporary_folder.hpp"

#include <gtest/gtest.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLUnstructuredGridReader.h>

using namespace pfv;
using namespace pfv::testing;

namespace {

double value(vtkFieldData* data, const char* name, vtkIdType at, int component = 0) {
  vtkDataArray* array = data->GetArray(name);
  if (!array) {
    ADD_FAILURE() << name << " is not there";
    return NAN;
  }
  return array->GetComponent(at, component);
}

void expect_pores(const std::filesystem::path& folder, const SteadyFlow& flow, vtkIdType images) {
  vtkNew<vtkXMLUnstructuredGridReader> reader;
  reader->SetFileName((folder / "pores.vtu").c_str());
  reader->Update();
  vtkUnstructuredGrid* grid = reader->GetOutput();
  const auto& [pores, throats] = std::tie(flow.network.pores, flow.network.throats);
  ASSERT_EQ(grid->GetNumberOfPoints(), static_cast<vtkIdType>(pores.size()) + images);
  ASSERT_EQ(grid->GetNumberOfCells(), static_cast<vtkIdType>(throats.size()));
  for (std::size_t i = 0; i < pores.size(); ++i) {
    const auto at = static_cast<vtkIdType>(i);
    EXPECT_EQ(Vec3(grid->GetPoint(at)), pores.centre[i]);
    EXPECT_EQ(value(grid->GetPointData(), "pressure", at), flow.pressure[i]);
    EXPECT_EQ(value(grid->GetPointData(), "volume", at), pores.volume[i]);
    EXPECT_EQ(value(grid->GetPointData(), "void_volume", at), pores.void_volume[i]);
  }
  for (std::size_t t = 0; t < throats.size(); ++t) {
    const auto at = static_cast<vtkIdType>(t);
    EXPECT_EQ(value(grid->GetCellData(), "conductance", at), flow.system.conductance[t]);
    EXPECT_EQ(value(grid->GetCellData(), "flux", at), throat_flux(flow.network, flow.system, flow.pressure, t));
    const vtkIdType ahead = grid->GetCell(at)->GetPointId(1);
    EXPECT_LT((Vec3(grid->GetPoint(ahead)) - flow.network.centre_ahead(t)).norm(), 1e-14);
  }
}

TEST(WriteVtk, IsReadBackByVtk) {
  Case problem = flow_through(packing_from("g200.txt"));
  problem.buoyancy = Buoyancy{1000, {0, 0, -9.81}};
  const SteadyFlow flow = solved(problem);
  const TemporaryFolder folder;
  write_vtk(folder.path(), problem.packing, flow);
  expect_pores(folder.path(), flow, 0);

  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName((folder.path() / "spheres.vtp").c_str());
  reader->Update();
  vtkPolyData* spheres = reader->GetOutput();
  ASSERT_EQ(spheres->GetNumberOfPoints(), 200);
  for (int k = 0; k < 200; ++k) {
    EXPECT_EQ(Vec3(spheres->GetPoint(k)), problem.packing.spheres[k].centre);
    EXPECT_EQ(value(spheres->GetPointData(), "radius", k), problem.packing.spheres[k].radius);
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_EQ(value(spheres->GetPointData(), "pressure_force", k, axis), flow.forces.pressure[k][axis]);
      EXPECT_EQ(value(spheres->GetPointData(), "viscous_force", k, axis), flow.forces.viscous[k][axis]);
      EXPECT_EQ(value(spheres->GetPointData(), "buoyancy", k, axis), (*flow.forces.buoyancy)[k][axis]);
    }
  }
}

TEST(WriteVtk, EndsThroatsThatLeaveAPeriodicBoxAtImages) {
  Case problem;
  problem.packing = random_packing({.spheres = 40, .solid_fraction = .4, .seed = 2, .periodic = {true, true, true}});
  problem.faces = flow_along(Axis::z, 1, {true, true, true}, problem.packing.box);
  const SteadyFlow flow = solved(problem);
  const TemporaryFolder folder;
  write_vtk(folder.path(), problem.packing, flow);
  const auto leaving = std::ranges::count_if(flow.network.throats.shift, [](const Shift& s) { return s != Shift{}; });
  ASSERT_GT(leaving, 50);
  expect_pores(folder.path(), flow, leaving);
}

} // namespace
