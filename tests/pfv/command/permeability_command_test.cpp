#include "support/run_program.hpp"
#include "support/temporary_file.hpp"

#include <cmath>
#include <fstream>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

using pfv::testing::run_program;
using pfv::testing::TemporaryFile;

namespace {

const std::string data = TEST_DATA;

pfv::testing::ProgramResult permeability(const std::string& arguments) {
  return run_program(std::string(PFV_PROGRAM) + " permeability " + arguments);
}

nlohmann::json answer(const std::string& arguments) {
  const auto result = permeability(arguments + " --json");
  EXPECT_EQ(result.exit_code, 0) << result.error;
  EXPECT_EQ(result.error, "");
  return nlohmann::json::parse(result.output);
}

void expect_bad_input(const std::string& arguments, const std::string& words) {
  const auto result = permeability(arguments);
  EXPECT_EQ(result.exit_code, 2) << arguments;
  EXPECT_EQ(result.output, "");
  EXPECT_EQ(std::ranges::count(result.error, '\n'), 1) << result.error;
  EXPECT_NE(result.error.find(words), std::string::npos) << result.error;
}

TEST(PermeabilityCommand, PrintsOneJsonObject) {
  const auto json = answer(data + "/g200.txt --axis y");
  EXPECT_EQ(json["spheres"], 200);
  EXPECT_EQ(json["pores"], 1101);
  EXPECT_GT(json["unknowns"], 500);
  EXPECT_NEAR(json["porosity"], 0.48, 1e-6);
  EXPECT_GT(json["permeability"], 0);
  EXPECT_NEAR(json["flux_in"].get<double>() / json["flux_out"].get<double>(), 1, 1e-10);
  EXPECT_EQ(json["contracted_throats"], 0);
  EXPECT_TRUE(json["stages"].contains("triangulate"));
  EXPECT_GT(json["cpu_seconds"], 0);
  EXPECT_GT(json["peak_memory_bytes"], 1e6);
}

TEST(PermeabilityCommand, ScalesWithOptions) {
  const double k = answer(data + "/g200.txt --axis y")["permeability"];
  EXPECT_NEAR(answer(data + "/g200.txt --axis y --viscosity 0.001")["permeability"].get<double>() / k, 1, 1e-9);
  EXPECT_NEAR(answer(data + "/g200.txt --axis y --solver gauss-seidel")["permeability"].get<double>() / k, 1, 1e-8);
  EXPECT_GT(std::abs(answer(data + "/g200.txt --axis x")["permeability"].get<double>() / k - 1), 1e-3);
  EXPECT_LT(answer(data + "/g200.txt --axis y --walls original")["permeability"].get<double>() / k, 0.85);
}

TEST(PermeabilityCommand, ReadsPackingsOfOtherTools) {
  const std::string yade = data + "/formats/yade_text.txt", dump = data + "/formats/liggghts.dump";
  const double k = answer(yade + " --box 0,0,0,1,1,1")["permeability"];
  const double k_mm = answer(yade + " --scale 1e-3 --box 0,0,0,1,1,1")["permeability"];
  EXPECT_NEAR(k_mm / k, 1e-6, 1e-15);
  EXPECT_NEAR(answer(yade + " --box -1,0,0,2,1,1")["porosity"].get<double>(),
              (answer(yade + " --box 0,0,0,1,1,1")["porosity"].get<double>() + 2) / 3, 1e-9);
  const auto json = answer(dump + " --periodic y");
  EXPECT_EQ(json["spheres"], 3);
  ASSERT_EQ(json["notes"].size(), 1U);
  EXPECT_EQ(json["notes"][0], dump + ": the last of 3 snapshots, time step 20");
  EXPECT_NE(permeability(dump).output.find("its box repeats along y"), std::string::npos);
  expect_bad_input(yade, "--box 0.0375,0.0375,0.0375,0.875,0.7,0.95");
  expect_bad_input(yade + " --box 0,0,1", "box \"0,0,1\" must be six numbers");
  expect_bad_input(yade + " --scale -1", "scale \"-1\" must be a positive number");
}

TEST(PermeabilityCommand, ReadsACase) {
  const TemporaryFile file("lattice.toml", "[packing]\ngenerator = \"simple_cubic\"\nsolid_fraction = \"touching\"\n"
                                           "cells = 2\n[flow]\naxis = \"x\"\n");
  const auto json = answer(file.path().string());
  EXPECT_NEAR(json["permeability"], 2.46746e-3, 1e-8);
  EXPECT_GT(json["contracted_throats"], 0);
}

const std::string lattice = "[packing]\ngenerator = \"bcc\"\nsolid_fraction = \"touching\"\n";

TEST(PermeabilityCommand, RepeatsTheBox) {
  const TemporaryFile file("bcc.toml", lattice + "[flow]\naxis = \"x\"\nperiodic = [\"x\", \"y\", \"z\"]\n");
  const auto json = answer(file.path().string());
  EXPECT_EQ(json["spheres"], 2);
  EXPECT_NEAR(json["permeability"], 5.1270e-4 * 0.75, 1e-8); // d^2 = 3/4
  EXPECT_NEAR(json["mean_flux"][0], -5.1270e-4 * 0.75, 1e-8);
  const TemporaryFile walls("walls.toml", lattice + "[flow]\naxis = \"x\"\n");
  EXPECT_NEAR(answer("--periodic x,y,z " + walls.path().string())["permeability"], json["permeability"], 1e-12);
  EXPECT_FALSE(answer(walls.path().string()).contains("mean_flux"));
  EXPECT_NE(permeability(file.path().string()).output.find("mean flux"), std::string::npos);
}

TEST(PermeabilityCommand, ReportsThePressureOfAPump) {
  const TemporaryFile file("pump.toml", lattice + "[faces]\nz_min = { pressure = 2 }\nz_max = { flux = 1e-3 }\n");
  const auto json = answer(file.path().string());
  EXPECT_NEAR(json["face_flux"]["z_max"], -1e-3, 1e-15);
  EXPECT_NEAR(json["face_pressure"]["z_max"], 2 + 1e-3 / (5.1270e-4 * 0.75), 1e-3);
  EXPECT_FALSE(json["face_pressure"].contains("z_min"));
  EXPECT_NEAR(json["permeability"], 5.1270e-4 * 0.75, 1e-8);
  EXPECT_NE(permeability(file.path().string()).output.find("pumped face"), std::string::npos);
}

TEST(PermeabilityCommand, ChoosesRulesByCaseFileOrOption) {
  const TemporaryFile file("rules.toml", "[packing]\nfile = \"" + data + "/g200.txt\"\n[flow]\naxis = \"z\"\n" +
                                             "[pfv]\nwalls = \"no-slip\"\nconductance = \"mixed-area\"\n");
  const auto from_file = answer(file.path().string());
  EXPECT_EQ(from_file["walls"], "no-slip");
  EXPECT_EQ(from_file["conductance"], "mixed-area");
  const auto said = answer(data + "/g200.txt --walls no-slip --conductance mixed-area");
  EXPECT_EQ(from_file["permeability"], said["permeability"]);
  EXPECT_EQ(from_file["digest"], said["digest"]);
  EXPECT_EQ(answer(file.path().string() + " --walls mirror")["walls"], "mirror");
  EXPECT_LT(said["permeability"], answer(data + "/g200.txt --conductance mixed-area")["permeability"]);
}

TEST(PermeabilityCommand, WritesForcesAndFiles) {
  const TemporaryFile place("here", "");
  const std::string folder = place.path().parent_path().string();
  answer(data + "/bcc9.txt --forces " + folder + "/forces.csv --vtk " + folder + "/vtk");
  std::ifstream forces(folder + "/forces.csv");
  std::string line;
  int lines = 0;
  while (std::getline(forces, line))
    ++lines;
  EXPECT_EQ(lines, 10);
  EXPECT_TRUE(std::filesystem::exists(folder + "/vtk/pores.vtu"));
  EXPECT_TRUE(std::filesystem::exists(folder + "/vtk/spheres.vtp"));
}

TEST(PermeabilityCommand, AnswersEveryPackingWithoutNan) {
  for (const char* name : {"g200", "g2000", "bcc9", "bcc9jit"}) {
    const auto result = permeability(data + "/" + name + ".txt");
    EXPECT_EQ(result.exit_code, 0) << result.error;
    EXPECT_EQ(result.output.find("nan"), std::string::npos) << name;
    EXPECT_EQ(result.output.find("inf"), std::string::npos) << name;
  }
}

TEST(PermeabilityCommand, RefusesBadInputInOneLine) {
  expect_bad_input("missing.txt", "missing.txt");
  expect_bad_input(data + "/g200.txt --axis w", "\"w\" must be one of x, y, z");
  expect_bad_input(data + "/g200.txt --solver jacobi", "jacobi");
  expect_bad_input(data + "/g200.txt --walls rough", "walls \"rough\" is not one of mirror, no-slip, original");
  expect_bad_input(data + "/g200.txt --conductance x", "is not one of hydraulic-radius, mixed-area");
  expect_bad_input(data + "/g200.txt --periodic x,w", "axis \"w\" must be one of x, y, z");
  expect_bad_input(data + "/g200.txt --viscosity 0", "viscosity");
  expect_bad_input(data + "/g200.txt --viscosity water", "water");
  expect_bad_input(data + "/g200.txt --unknown", "--unknown");
  expect_bad_input(data + "/g200.txt --forces /nowhere/forces.csv", "/nowhere/forces.csv");
  const TemporaryFile negative("bad.txt", "# box 0 0 0 1 1 1\n.5 .5 .5 -.1\n");
  expect_bad_input(negative.path().string(), "bad.txt:2");
}

TEST(PermeabilityCommand, RefusesACaseWithoutALevel) {
  const TemporaryFile file("lost.toml", lattice + "[faces]\nz_max = { flux = 1 }\n");
  expect_bad_input(file.path().string(), "leave the pressure without a level");
}

TEST(PermeabilityCommand, ExitsWithThreeWhenItCannotSolve) {
  const TemporaryFile file("corner.toml",
                           "[packing]\ngenerator = \"nine_spheres\"\n[faces]\nx_min = { pressure = 1.0 }\n"
                           "y_min = { pressure = 2.0 }\n");
  const auto result = permeability(file.path().string());
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_EQ(result.output, "");
  EXPECT_NE(result.error.find("must have the same pressure"), std::string::npos) << result.error;
}

} // namespace
