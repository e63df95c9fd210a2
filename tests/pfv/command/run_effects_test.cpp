#include "support/run_program.hpp"
#include "support/temporary_file.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

using namespace pfv::testing;

namespace {

constexpr const char* dry = "[packing]\ngenerator = \"random\"\nspheres = 50\nsolid_fraction = 0.4\n[run]\nsteps = 3\n";

ProgramResult run(const std::string& scene, const std::string& options = "") {
  const TemporaryFile file("scene.toml", scene);
  return run_program(std::string(PFV_PROGRAM) + " run " + file.path().string() + " " + options);
}

TEST(RunCommand, ListsWhatTheSceneNamesAndNothingElse) {
  const auto report = run(dry);
  ASSERT_EQ(report.exit_code, 0);
  EXPECT_NE(report.output.find("contacts, linear"), std::string::npos) << report.output;
  EXPECT_EQ(report.output.find("lubrication"), std::string::npos) << report.output;
  const auto answer = nlohmann::json::parse(run(dry, "--json").output);
  EXPECT_EQ(answer.at("effects").size(), 1u);
  EXPECT_FALSE(answer.contains("films"));
  EXPECT_EQ(answer.at("stages").size(), 2u);
}

TEST(RunCommand, ReportsFilmsTheirLimitAndTheirEnergy) {
  const std::string scene = std::string(dry) + "[fluid]\nviscosity = 2\n[lubrication]\nresists = [\"normal\"]\n"
                                               "[gravity]\nacceleration = [0, 0, -9.81]\n";
  const auto report = run(scene);
  ASSERT_EQ(report.exit_code, 0);
  for (const char* part : {"lubrication, 2 Pa s, gaps of 0.01 to 0.5 of the smaller radius, normal\n",
                           "s of the lubrication", "of them at the roughness", "J in lubrication", "  lubrication  "})
    EXPECT_NE(report.output.find(part), std::string::npos) << part << "\n" << report.output;
  const auto answer = nlohmann::json::parse(run(scene, "--json").output);
  EXPECT_GT(answer.at("films").at("count"), 0);
  EXPECT_GT(answer.at("energy").at("lubrication"), 0);
  EXPECT_EQ(answer.at("stress").size(), 3u);
  EXPECT_GT(answer.at("lubrication_limit"), answer.at("step"));
  EXPECT_FALSE(answer.contains("pores"));
}

TEST(RunCommand, GrowsGrainsToAStressAndSavesThem) {
  const TemporaryFile saved("grown.checkpoint", "");
  const std::string grains = "[packing]\ngenerator = \"random\"\nspheres = 50\nsolid_fraction = 0.4\n[contact]\n"
                             "young = 1e6\n[local_damping]\nshare = 0.3\n";
  const auto report = run(grains + "[growth]\nrate = 0.05\nstress = 1e3\n[run]\nsteps = 20000\nunbalanced = 1e-2\n",
                          "--save " + saved.path().string());
  ASSERT_EQ(report.exit_code, 0) << report.error;
  for (const char* part : {"growth of radii, 0.05 1/s at first, to 1000 Pa\n", "grown         radii by 1.",
                           "J of growth\n", "  growth        "})
    EXPECT_NE(report.output.find(part), std::string::npos) << part << "\n" << report.output;
  const auto goes_on =
      run(grains + "[run]\nuntil = 1e9\nsteps = 20000\n", "--steps 1 --json --restart " + saved.path().string());
  EXPECT_EQ(goes_on.exit_code, 0) << goes_on.error;
}

TEST(RunCommand, RefusesFilmsOfAnUnnamedFluidInOneLine) {
  const auto refused = run(std::string(dry) + "[lubrication]\n");
  EXPECT_NE(refused.exit_code, 0);
  EXPECT_NE(refused.error.find("[lubrication] needs the viscosity (Pa s) of [fluid]"), std::string::npos)
      << refused.error;
}

} // namespace
