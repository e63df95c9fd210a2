#include "pfv/vtk/write_vtk.hpp"

#include "pfv/flow/fluxes.hpp"
#include "pfv/problem/error.hpp"

#include <fmt/format.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLPolyDataWriter.h>
#include <vtkXMLUnstructuredGridWriter.h>

namespace pfv {
namespace {

void add_scalars(vtkFieldData* to, const char* name, const std::vector<double>& values) {
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  for (const double value : values)
    array->InsertNextValue(value);
  to->AddArray(array);
}

void add_vectors(vtkFieldData* to, const char* name, const std::vector<Vec3>& values) {
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  array->SetNumberOfComponents(3);
  for (const Vec3& value : values)
    array->InsertNextTuple(value.data());
  to->AddArray(array);
}

void write(vtkXMLWriter* writer, vtkDataObject* data, const std::filesystem::path& file) {
  writer->SetFileName(file.c_str());
  writer->SetInputDataObject(data);
  if (writer->Write() != 1)
    throw InputError(fmt::format("\"{}\" cannot be written", file.string()));
}

/// A point per pore and, in a periodic box, one more for every throat that leaves it: the image where it ends.
void write_pores(const std::filesystem::path& file, const SteadyFlow& flow) {
  const auto& pores = flow.network.pores;
  const auto& throats = flow.network.throats;
  std::vector<double> pressure = flow.pressure, volume = pores.volume, void_volume = pores.void_volume;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const Vec3& centre : pores.centre)
    points->InsertNextPoint(centre.data());
  const auto image_ahead = [&](std::size_t t) {
    const auto [i, j] = throats.pores[t];
    pressure.push_back(flow.pressure[i] - pressure_drop(flow.network, flow.system, flow.pressure, t));
    volume.push_back(pores.volume[j]);
    void_volume.push_back(pores.void_volume[j]);
    return points->InsertNextPoint(flow.network.centre_ahead(t).data());
  };
  vtkNew<vtkCellArray> lines;
  std::vector<double> flux;
  for (std::size_t t = 0; t < throats.size(); ++t) {
    const bool leaves = !throats.shift.empty() && throats.shift[t] != Shift{};
    const vtkIdType ends[2] = {throats.pores[t][0], leaves ? image_ahead(t) : throats.pores[t][1]};
    lines->InsertNextCell(2, ends);
    flux.push_back(throat_flux(flow.network, flow.system, flow.pressure, t));
  }
  vtkNew<vtkUnstructuredGrid> grid;
  grid->SetPoints(points);
  grid->SetCells(VTK_LINE, lines);
  add_scalars(grid->GetPointData(), "pressure", pressure);
  add_scalars(grid->GetPointData(), "volume", volume);
  add_scalars(grid->GetPointData(), "void_volume", void_volume);
  add_scalars(grid->GetCellData(), "conductance", flow.system.conductance);
  add_scalars(grid->GetCellData(), "flux", flux);
  vtkNew<vtkXMLUnstructuredGridWriter> writer;
  write(writer, grid, file);
}

void write_spheres(const std::filesystem::path& file, const Packing& packing, const FluidForces& forces) {
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> vertices;
  std::vector<double> radius;
  for (const Sphere& sphere : packing.spheres) {
    const vtkIdType point = points->InsertNextPoint(sphere.centre.data());
    vertices->InsertNextCell(1, &point);
    radius.push_back(sphere.radius);
  }
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetVerts(vertices);
  add_scalars(data->GetPointData(), "radius", radius);
  add_vectors(data->GetFieldData(), "box", {packing.box.lower, packing.box.upper});
  add_vectors(data->GetPointData(), "pressure_force", forces.pressure);
  add_vectors(data->GetPointData(), "viscous_force", forces.viscous);
  if (forces.buoyancy)
    add_vectors(data->GetPointData(), "buoyancy", *forces.buoyancy);
  vtkNew<vtkXMLPolyDataWriter> writer;
  write(writer, data, file);
}

} // namespace

void write_vtk(const std::filesystem::path& folder, const Packing& packing, const SteadyFlow& flow) {
  std::error_code failure;
  std::filesystem::create_directories(folder, failure);
  if (failure)
    throw InputError(fmt::format("folder \"{}\" cannot be made: {}", folder.string(), failure.message()));
  write_pores(folder / "pores.vtu", flow);
  write_spheres(folder / "spheres.vtp", packing, flow.forces);
}

} // namespace pfv
