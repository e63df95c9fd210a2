// Packings from VTK files: of YADE, of LIGGGHTS and our own.
#include "pfv/problem/packing_file.hpp"
#include "pfv/vtk/write_vtk.hpp"
#include "support/packing_files.hpp"
#include "support/packings.hpp"
#include "support/temporary_folder.hpp"

#include <gtest/gtest.h>

namespace pfv {
namespace {

using testing::complaint_of;
using testing::format_sample;
using testing::read_text_as;

const Box box{Vec3(0, -.5, 0), Vec3(1, 1.5, 2)};

/// Points are floats in the files of both tools, radii are doubles.
void expect_spheres(const std::string& name, const std::vector<Sphere>& expected) {
  const Packing packing = read_packing_file(format_sample(name), {.box = box}).packing;
  EXPECT_EQ(packing.box, box);
  ASSERT_EQ(packing.spheres.size(), expected.size()) << name;
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_LT((packing.spheres[i].centre - expected[i].centre).norm(), 1e-7) << name;
    EXPECT_EQ(packing.spheres[i].radius, expected[i].radius) << name;
  }
}

std::string points(const std::string& arrays) {
  return "<VTKFile type=\"PolyData\" version=\"0.1\" byte_order=\"LittleEndian\"><PolyData><Piece NumberOfPoints=\"2\">"
         "<PointData>" +
         arrays +
         "</PointData><Points><DataArray type=\"Float64\" NumberOfComponents=\"3\" format=\"ascii\">.25 .5 .5 .75 .5 .5"
         "</DataArray></Points></Piece></PolyData></VTKFile>";
}

std::string array(const std::string& name, const std::string& values, int components = 1) {
  return "<DataArray type=\"Float64\" Name=\"" + name + "\" NumberOfComponents=\"" + std::to_string(components) +
         "\" format=\"ascii\">" + values + "</DataArray>";
}

TEST(VtkSpheres, OfYade) {
  const std::vector<Sphere> spheres{{Vec3(.25, .5, .75), .2}, {Vec3(.75, .25, .25), .125}, {Vec3(.1, .1, .1), .0625}};
  for (const char* name : {"yade_spheres.vtu", "yade_ascii.vtu", "yade_exporter.vtk"})
    expect_spheres(name, spheres);
}

TEST(VtkSpheres, OfLiggghts) {
  const std::vector<Sphere> spheres{{Vec3(.52, 1.25, .5), .25}, {Vec3(.27, .5, .75), .2}, {Vec3(.77, .25, 1.25), .125}};
  for (const char* name : {"liggghts.vtp", "liggghts.vtu", "liggghts.vtk"})
    expect_spheres(name, spheres);
}

TEST(VtkSpheres, OursReadBackTheSameWithTheirBox) {
  const Case problem = testing::flow_through(testing::packing_from("g200.txt"));
  const testing::TemporaryFolder folder;
  write_vtk(folder.path(), problem.packing, testing::solved(problem));
  EXPECT_EQ(read_packing(folder.path() / "spheres.vtp"), problem.packing);
}

TEST(VtkSpheres, KnowsTheNamesOfSizes) {
  const std::vector<Sphere> spheres{{Vec3(.25, .5, .5), .125}, {Vec3(.75, .5, .5), .25}};
  for (const char* name : {"radius", "radii", "r", "Radius"})
    EXPECT_EQ(read_text_as("p.vtp", points(array(name, ".125 .25")), {.box = Box{}}).packing.spheres, spheres);
  EXPECT_EQ(read_text_as("p.xml", points(array("diameter", ".25 .5")), {.box = Box{}}).packing.spheres, spheres);
  EXPECT_EQ(read_text_as("p.vtp", points(array("diameter", "7 7") + array("radius", ".125 .25")), {.box = Box{}})
                .packing.spheres,
            spheres);
}

TEST(VtkSpheresRefuses, WhatIsNoPacking) {
  EXPECT_EQ(complaint_of("p.vtp", points("")),
            "p.vtp: point arrays \"none\" must have one named radius, radii, r or diameter");
  EXPECT_EQ(complaint_of("p.vtp", points(array("id", "1 2") + array("mass", "1 2"))),
            "p.vtp: point arrays \"id, mass\" must have one named radius, radii, r or diameter");
  EXPECT_EQ(
      complaint_of("p.vtp", points(array("radius", "1 2 3 4 5 6", 3))),
      "p.vtp: point array \"radius\" has 6 values in 3 components for 2 points and must have one number for each");
  EXPECT_EQ(
      complaint_of("p.vtp", points(array("radius", ".1 .2"))),
      "p.vtp: no box; --box, box in [packing] or, in text, a line \"# box x0 y0 z0 x1 y1 z1\" must say it; that of "
      "the spheres is --box 0.15,0.3,0.3,0.95,0.7,0.7");
  EXPECT_EQ(complaint_of("p.vtp", points(array("radius", ".1 -2")), {.box = Box{}}),
            "p.vtp: point 1: radius \"-2\" must be a positive number (m)");
}

TEST(VtkSpheresRefuses, OtherTypesAndOtherFiles) {
  EXPECT_EQ(complaint_of("p.pvd", "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\"/>\n"),
            "p.pvd: VTK type \"Collection\" must be PolyData (.vtp) or UnstructuredGrid (.vtu)");
  EXPECT_EQ(complaint_of("p.vtp", "0 0 0 1\n"),
            "p.vtp: VTK type \"\" must be PolyData (.vtp) or UnstructuredGrid (.vtu)");
  EXPECT_EQ(complaint_of("p.vtk", "# vtk DataFile Version 3.0\nbox\nASCII\nDATASET RECTILINEAR_GRID\nDIMENSIONS 1 1 1\n"
                                  "X_COORDINATES 1 double\n0\nY_COORDINATES 1 double\n0\nZ_COORDINATES 1 double\n0\n"),
            "p.vtk: VTK without points of their own; PolyData or UnstructuredGrid is needed");
}

TEST(VtkSpheresRefuses, WhatTakesVtksReaderDown) {
  const std::string cells = "<VTKFile type=\"UnstructuredGrid\" version=\"0.1\"><UnstructuredGrid>"
                            "<Piece NumberOfPoints=\"1\" NumberOfCells=\"-5\"><Points><DataArray type=\"Float64\" "
                            "NumberOfComponents=\"3\" format=\"ascii\">0 0 0</DataArray></Points></Piece>"
                            "</UnstructuredGrid></VTKFile>";
  const std::string message = complaint_of("p.vtu", cells);
  EXPECT_TRUE(message.starts_with("p.vtu: not sound VTK: ")) << message;
}

TEST(VtkSpheresRefuses, DamagedFilesInOneLine) {
  for (const char* name :
       {"yade_spheres.vtu", "yade_ascii.vtu", "yade_exporter.vtk", "liggghts.vtp", "liggghts.vtu", "liggghts.vtk"})
    testing::expect_refused_or_read(name, 150, {.box = Box{Vec3(-1, -1, -1), Vec3(3, 3, 3)}});
}

} // namespace
} // namespace pfv
