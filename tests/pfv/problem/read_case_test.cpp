#include "pfv/problem/case.hpp"
#include "pfv/problem/error.hpp"
#include "pfv/problem/generate.hpp"
#include "support/message_of.hpp"
#include "support/temporary_file.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <limits>

namespace pfv {
namespace {

using testing::message_of;
using testing::TemporaryFile;

Case read(std::string_view text) {
  const TemporaryFile file("c.toml", text);
  return read_case(file.path());
}

/// What read_case says of a file with this text, without the folder.
std::string complaint(std::string_view text) {
  const TemporaryFile file("c.toml", text);
  std::string message = message_of<InputError>([&] { read_case(file.path()); });
  const std::string folder = file.path().parent_path().string() + "/";
  if (message.starts_with(folder))
    message.erase(0, folder.size());
  return message;
}

/// The message about `lines` when they come after a packing and a flow, whose six lines are sound.
std::string complaint_after_flow(const std::string& lines) {
  return complaint("[packing]\nbox = [[0, 0, 0], [1, 1, 1]]\nspheres = [[0.5, 0.5, 0.5, 0.1]]\n[flow]\n"
                   "axis = \"z\"\n\n" +
                   lines);
}

/// The message about a [packing] of these lines, which begin on line 4.
std::string complaint_about_packing(const std::string& lines) {
  return complaint("[flow]\naxis = \"z\"\n[packing]\n" + lines);
}

const std::string nine = "[packing]\ngenerator = \"nine_spheres\"\n";

TEST(ReadCase, GivesEveryPart) {
  const Case problem = read(R"(
    name = "all"
    [packing]
    box = [[0, 0, 0], [1, 2.5, 1]]
    spheres = [
      [0.25, 0.5, 0.5, 0.125],
      [1, 2, 1, 0.25],
    ]
    [fluid]
    viscosity = 2
    [faces]
    x_min = "slip"
    y_max = { pressure = 3 }
    z_max = { pressure = -1.5 }
    [buoyancy]
    fluid_density = 1000
    gravity = [0, 0, -9.81]
  )");
  Case expected{"all",
                {{Vec3(0, 0, 0), Vec3(1, 2.5, 1)}, {{Vec3(0.25, 0.5, 0.5), 0.125}, {Vec3(1, 2, 1), 0.25}}},
                {2},
                {},
                Buoyancy{1000, Vec3(0, 0, -9.81)}};
  expected.faces[index(Face::y_max)] = Pressure{3};
  expected.faces[index(Face::z_max)] = Pressure{-1.5};
  EXPECT_EQ(problem, expected);
}

TEST(ReadCase, WhatIsLeftOutHasDefaults) {
  const Case problem = read(nine + "[flow]\naxis = \"x\"\n");
  EXPECT_EQ(problem, (Case{"c", nine_spheres(), Fluid{1.0}, flow_along(Axis::x, 1.0), std::nullopt}));
}

TEST(ReadCase, TangentialVelocityOnOpenFaces) {
  EXPECT_EQ(read(nine + "[flow]\naxis = \"x\"\ntangential = \"free\"\n").faces,
            flow_along(Axis::x, 1.0, Tangential::free));
  const Case one = read(nine + "[faces]\nx_min = { pressure = 1, tangential = \"free\" }\n");
  EXPECT_EQ(one.faces[index(Face::x_min)], (FaceCondition{Pressure{1, Tangential::free}}));
}

TEST(ReadCase, Generators) {
  const auto packing = [](const std::string& lines) {
    return read("[flow]\naxis = \"z\"\n[packing]\n" + lines).packing;
  };
  EXPECT_EQ(packing("generator = \"simple_cubic\"\nsolid_fraction = 0.3\ncells = 2\ncell_size = 0.5"),
            lattice_packing(Lattice::simple_cubic, 0.3, 2, 0.5));
  EXPECT_EQ(packing("generator = \"bcc\"\nsolid_fraction = \"touching\""),
            lattice_packing(Lattice::bcc, touching_solid_fraction(Lattice::bcc), 1));
  EXPECT_EQ(packing("generator = \"fcc\"\nsolid_fraction = 0.5"), lattice_packing(Lattice::fcc, 0.5, 1));
  EXPECT_EQ(packing("generator = \"nine_spheres\"\nsize = 2"), nine_spheres(2));
  EXPECT_EQ(packing("generator = \"random\"\nspheres = 12\nsolid_fraction = 0.2\nradius_ratio = 2\nseed = 7\nsize = 3"),
            random_packing({12, 0.2, 2, 7, 3}));
}

TEST(ReadCase, AFileIsRelativeToTheCase) {
  const TemporaryFile file("c.toml", "[packing]\nfile = \"sub/p.txt\"\n[flow]\naxis = \"z\"\n");
  std::filesystem::create_directory(file.path().parent_path() / "sub");
  std::ofstream(file.path().parent_path() / "sub/p.txt") << "# box 0 0 0 1 1 1\n0.5 0.5 0.5 0.25\n";
  EXPECT_EQ(read_case(file.path()).packing, (Packing{{}, {{Vec3(0.5, 0.5, 0.5), 0.25}}}));
}

TEST(ToToml, ReadsBackTheSame) {
  Case problem = read(nine + "[flow]\naxis = \"x\"\n");
  problem.name = "quotes \" and \\, a tab\t, a line\n, \x7f and µ";
  problem.packing.spheres[0] = {Vec3(0.1 + 0.2, 1 / 3.0, 5e-324), std::numeric_limits<double>::min()};
  problem.packing.spheres[1] = {Vec3(-0.0, 1, 0), 9007199254740993e6};
  problem.fluid.viscosity = 1e22;
  problem.faces[index(Face::x_min)] = Pressure{-9007199254740994.0};
  problem.faces[index(Face::y_max)] = Pressure{1e15, Tangential::free};
  problem.buoyancy = Buoyancy{1e-5, Vec3(0, -0.0, -9.81)};
  const Case again = read(to_toml(problem));
  EXPECT_EQ(again, problem);
  EXPECT_EQ(to_toml(again), to_toml(problem));
  EXPECT_EQ(digest(again), digest(problem));
}

TEST(ReadCaseRefuses, FilesThatAreNotToml) {
  EXPECT_TRUE(complaint("name = \"a\"\nx =\n").starts_with("c.toml:2: not TOML: "));
  EXPECT_TRUE(complaint("name = \"a\"\nname = \"b\"\n").starts_with("c.toml:2: not TOML: "));
  EXPECT_EQ(message_of<InputError>([] { read_case("/nowhere/c.toml"); }),
            "/nowhere/c.toml: cannot be read: No such file or directory");
}

TEST(ReadCaseRefuses, UnknownKeysNamingTheValidOnes) {
  EXPECT_EQ(complaint_after_flow("[fluids]\n"),
            "c.toml:7: unknown key \"fluids\" in a case; valid keys: name, packing, fluid, flow, faces, "
            "pressure_points, buoyancy, pfv");
  EXPECT_EQ(complaint_after_flow("[fluid]\nviscocity = 1\n"),
            "c.toml:8: unknown key \"viscocity\" in [fluid]; valid keys: viscosity");
  EXPECT_EQ(complaint_after_flow("[buoyancy]\nfluid_density = 1\ndensity = 1\ngravity = [0, 0, 1]\n"),
            "c.toml:9: unknown key \"density\" in [buoyancy]; valid keys: fluid_density, gravity");
  EXPECT_EQ(complaint(nine + "[flow]\naxis = \"z\"\ndrop = 1\n"),
            "c.toml:5: unknown key \"drop\" in [flow]; valid keys: axis, pressure_drop, periodic, tangential");
  EXPECT_EQ(complaint(nine + "[faces]\ntop = \"slip\"\n"),
            "c.toml:4: unknown key \"top\" in [faces]; valid keys: x_min, x_max, y_min, y_max, z_min, z_max");
  EXPECT_EQ(complaint(nine + "[faces]\nz_max = { p = 1 }\n"),
            "c.toml:4: unknown key \"p\" in z_max; valid keys: pressure, tangential, flux, periodic");
}

TEST(ReadCaseRefuses, UnknownPackingKeysByKindOfPacking) {
  EXPECT_EQ(complaint_about_packing("file = \"a\"\nseed = 1\n"),
            "c.toml:5: unknown key \"seed\" in [packing] with a file; valid keys: file, scale, box");
  EXPECT_EQ(complaint_about_packing("box = [[0, 0, 0], [1, 1, 1]]\nspheres = []\nsize = 1\n"),
            "c.toml:6: unknown key \"size\" in [packing] with spheres; valid keys: box, spheres");
  EXPECT_EQ(complaint_about_packing("generator = \"fcc\"\nsolid_fraction = 0.1\nseed = 1\n"),
            "c.toml:6: unknown key \"seed\" in [packing] with a lattice; valid keys: generator, solid_fraction, "
            "cells, cell_size");
  EXPECT_EQ(complaint_about_packing("generator = \"nine_spheres\"\ncells = 2\n"),
            "c.toml:5: unknown key \"cells\" in [packing] with nine_spheres; valid keys: generator, size");
  EXPECT_EQ(complaint_about_packing("generator = \"random\"\ncells = 2\n"),
            "c.toml:5: unknown key \"cells\" in [packing] with random; valid keys: generator, spheres, "
            "solid_fraction, radius_ratio, seed, size");
}

TEST(ReadCaseRefuses, PackingsThatAreNotOneThing) {
  const std::string message = "c.toml:3: [packing] must have exactly one of file, generator, or box with spheres";
  EXPECT_EQ(complaint_about_packing(""), message);
  EXPECT_EQ(complaint_about_packing("file = \"a\"\ngenerator = \"fcc\"\n"), message);
  EXPECT_EQ(complaint_about_packing("file = \"a\"\nspheres = []\n"), message);
  EXPECT_EQ(complaint_about_packing("generator = \"random\"\nbox = [[0, 0, 0], [1, 1, 1]]\n"), message);
  EXPECT_EQ(complaint("[flow]\naxis = \"z\"\n"), "c.toml:1: the case has no \"packing\"; it is needed");
  EXPECT_EQ(complaint("packing = 3\n"), "c.toml:1: packing \"3\" must be a table");
}

TEST(ReadCaseRefuses, BadGenerators) {
  EXPECT_EQ(complaint_about_packing("generator = \"hcp\"\n"),
            "c.toml:4: generator \"hcp\" must be one of simple_cubic, bcc, fcc, nine_spheres, random");
  EXPECT_EQ(complaint_about_packing("generator = \"fcc\"\n"),
            "c.toml:3: [packing] has no \"solid_fraction\"; it is needed");
  EXPECT_EQ(complaint_about_packing("generator = \"fcc\"\nsolid_fraction = \"dense\"\n"),
            "c.toml:5: solid_fraction \"dense\" must be a number or \"touching\"");
  EXPECT_EQ(complaint_about_packing("generator = \"simple_cubic\"\nsolid_fraction = 0.6\n"),
            "c.toml:3: solid_fraction \"0.6\" must be above 0 and at most 0.5235987755982988, where the spheres touch");
  EXPECT_EQ(complaint_about_packing("generator = \"fcc\"\nsolid_fraction = 0.6\ncells = 2.0\n"),
            "c.toml:6: cells \"2.0\" must be a whole number");
  EXPECT_EQ(complaint_about_packing("generator = \"fcc\"\nsolid_fraction = 0.6\ncells = 0\n"),
            "c.toml:6: cells \"0\" must be a whole number, 1 or more");
  EXPECT_EQ(complaint_about_packing("generator = \"nine_spheres\"\nsize = -1\n"),
            "c.toml:3: size \"-1\" must be a positive number (m)");
  EXPECT_EQ(complaint_about_packing("generator = \"random\"\nseed = -1\n"),
            "c.toml:5: seed \"-1\" must be a whole number, 0 or more");
  EXPECT_TRUE(complaint_about_packing("generator = \"random\"\nsolid_fraction = 0.7\n")
                  .starts_with("c.toml:3: solid_fraction \"0.7\" must be"));
}

TEST(ReadCaseRefuses, BadInlineSpheresAtTheirLine) {
  const std::string box = "box = [[0, 0, 0], [1, 1, 1]]\n";
  EXPECT_EQ(complaint_about_packing(box), "c.toml:3: [packing] has no \"spheres\"; it is needed");
  EXPECT_EQ(complaint_about_packing("spheres = []\n"), "c.toml:3: [packing] has no \"box\"; it is needed");
  EXPECT_EQ(complaint_about_packing(box + "spheres = []\n"),
            "c.toml:4: packing has \"0\" spheres and needs at least one");
  EXPECT_EQ(complaint_about_packing(box + "spheres = 1\n"),
            "c.toml:5: spheres \"1\" must be a list of [x, y, z, r] (m)");
  EXPECT_EQ(complaint_about_packing(box + "spheres = [\n[0, 0, 0, 0.1],\n[0, 0, 0]]\n"),
            "c.toml:7: sphere \"[ 0, 0, 0 ]\" must be four numbers [x, y, z, r] (m)");
  EXPECT_EQ(complaint_about_packing(box + "spheres = [\n[0, 0, 0, 0.1],\n[0, 0, 1, \"b\"]]\n"),
            "c.toml:7: sphere \"b\" must be a number");
  EXPECT_EQ(complaint_about_packing(box + "spheres = [\n[0, 0, 0, 0.1],\n[0, 0, 1, -0.1]]\n"),
            "c.toml:7: radius \"-0.1\" must be a positive number (m)");
  EXPECT_TRUE(complaint_about_packing(box + "spheres = [\n[0, 0, 0, 0.1],\n[0, 0, 0, 0.1]]\n")
                  .starts_with("c.toml:7: centre \"0 0 0\" must differ"));
  EXPECT_EQ(complaint_about_packing("box = [0, 0, 0, 1, 1, 1]\nspheres = []\n"),
            "c.toml:4: box \"[ 0, 0, 0, 1, 1, 1 ]\" must be two corners [[x, y, z], [x, y, z]] (m)");
  EXPECT_EQ(complaint_about_packing("box = [[0, 0], [1, 1, 1]]\nspheres = []\n"),
            "c.toml:4: box corner \"[ 0, 0 ]\" must be three numbers [x, y, z]");
}

TEST(ReadCaseRefuses, BadPackingFilesAtTheirOwnLine) {
  const TemporaryFile file("c.toml", "[packing]\nfile = \"p.txt\"\n[flow]\naxis = \"z\"\n");
  const auto packing = file.path().parent_path() / "p.txt";
  std::ofstream(packing) << "# box 0 0 0 1 1 1\n0.5 0.5 0.5 0\n";
  EXPECT_EQ(message_of<InputError>([&] { read_case(file.path()); }),
            packing.string() + ":2: radius \"0\" must be a positive number (m)");
}

TEST(ReadCaseRefuses, BadFlows) {
  const std::string message = "a case must have exactly one of [flow] and [faces]";
  EXPECT_EQ(complaint(nine), "c.toml:1: " + message);
  EXPECT_EQ(complaint(nine + "[flow]\naxis = \"z\"\n[faces]\nz_max = { pressure = 1 }\n"), "c.toml:5: " + message);
  EXPECT_EQ(complaint(nine + "[flow]\naxis = \"x\"\ntangential = \"slip\"\n"),
            "c.toml:5: tangential \"slip\" must be one of zero, free");
  EXPECT_EQ(complaint(nine + "[flow]\npressure_drop = 1\n"), "c.toml:3: [flow] has no \"axis\"; it is needed");
  EXPECT_EQ(complaint(nine + "[flow]\naxis = \"w\"\n"), "c.toml:4: axis \"w\" must be one of x, y, z");
  EXPECT_EQ(complaint(nine + "[flow]\naxis = 3\n"), "c.toml:4: axis \"3\" must be a text in quotes");
  EXPECT_EQ(complaint(nine + "[flow]\naxis = \"z\"\npressure_drop = 0\n"),
            "c.toml:5: pressure_drop \"0\" must be a finite number other than zero (Pa)");
  EXPECT_EQ(complaint(nine + "[flow]\naxis = \"z\"\npressure_drop = inf\n"),
            "c.toml:5: pressure_drop \"inf\" must be a finite number other than zero (Pa)");
}

TEST(ReadCaseRefuses, BadFaces) {
  EXPECT_EQ(complaint(nine + "[faces]\nz_min = \"open\"\n"),
            "c.toml:4: z_min \"open\" must be \"slip\", \"periodic\", { pressure = <Pa> }, { pressure = [[<m>, <Pa>], "
            "...], along = <axis> }, { flux = <m^3/s> } or { periodic = <Pa/m> }");
  EXPECT_EQ(complaint(nine + "[faces]\nz_min = {}\n"), "c.toml:4: z_min has no \"pressure\"; it is needed");
  EXPECT_EQ(complaint(nine + "[faces]\nz_min = { pressure = \"1\" }\n"), "c.toml:4: pressure \"1\" must be a number");
  EXPECT_EQ(complaint(nine + "[faces]\nz_min = { pressure = nan }\n"),
            "c.toml:3: z_min pressure \"nan\" must be a finite number (Pa)");
  EXPECT_EQ(complaint(nine + "[faces]\nz_min = \"slip\"\n"),
            "c.toml:3: faces \"slip\", \"slip\", \"slip\", \"slip\", \"slip\", \"slip\" leave the pressure without a "
            "level; at least one face or point must have a pressure, or a periodic axis a gradient");
}

TEST(ReadCaseRefuses, BadFluidsAndBuoyancies) {
  EXPECT_EQ(complaint_after_flow("[fluid]\nviscosity = -3\n"),
            "c.toml:8: viscosity \"-3\" must be a positive number (Pa s)");
  EXPECT_EQ(complaint_after_flow("[fluid]\nviscosity = \"water\"\n"), "c.toml:8: viscosity \"water\" must be a number");
  EXPECT_EQ(complaint_after_flow("fluid = 3\n"),
            "c.toml:7: unknown key \"fluid\" in [flow]; valid keys: axis, pressure_drop, periodic, tangential");
  EXPECT_EQ(complaint_after_flow("[buoyancy]\nfluid_density = 1000\n"),
            "c.toml:7: [buoyancy] has no \"gravity\"; it is needed");
  EXPECT_EQ(complaint_after_flow("[buoyancy]\nfluid_density = 1000\ngravity = -9.81\n"),
            "c.toml:9: gravity \"-9.81\" must be three numbers [x, y, z]");
  EXPECT_EQ(complaint_after_flow("[buoyancy]\nfluid_density = 0\ngravity = [0, 0, -9.81]\n"),
            "c.toml:7: fluid_density \"0\" must be a positive number (kg/m^3)");
}

} // namespace
} // namespace pfv
