#include "pfv/problem/text.hpp"
#include "support/run_program.hpp"
#include "support/temporary_file.hpp"
#include "support/temporary_folder.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

using pfv::testing::run_program;
using pfv::testing::TemporaryFile;
using pfv::testing::TemporaryFolder;

namespace {

const std::string grains =
    "[packing]\ngenerator = \"random\"\nspheres = 30\nsolid_fraction = 0.45\nradius_ratio = 1.35\n"
    "[contact]\nyoung = 1e6\n";
const std::string piston = grains + "[walls]\nz_max = { stress = 1000 }\n";
const std::string wet = piston + "[fluid]\nviscosity = 10\n[faces]\nz_max = { pressure = 0 }\n";

pfv::testing::ProgramResult run(const std::string& arguments) {
  return run_program(std::string(PFV_PROGRAM) + " run " + arguments);
}

nlohmann::json answer(const std::string& arguments) {
  const auto result = run(arguments + " --json");
  EXPECT_EQ(result.exit_code, 0) << result.error;
  EXPECT_EQ(result.error, "");
  return nlohmann::json::parse(result.output);
}

void expect_one_line(const pfv::testing::ProgramResult& result, int exit_code, const std::string& words) {
  EXPECT_EQ(result.exit_code, exit_code) << words;
  EXPECT_EQ(std::ranges::count(result.error, '\n'), 1) << result.error;
  EXPECT_NE(result.error.find(words), std::string::npos) << result.error;
}

int lines_of(const std::string& file) {
  const std::string text = pfv::read_text(file);
  return static_cast<int>(std::ranges::count(text, '\n'));
}

TEST(RunCommand, RunsADrySceneWithoutAnyStageOfAFlow) {
  const TemporaryFile scene("falling.toml", grains + "[gravity]\nacceleration = [0, 0, -9.81]\n");
  const auto json = answer(scene.path().string() + " --steps 20");
  EXPECT_EQ(json["scene"], "falling");
  EXPECT_EQ(json["grains"], 30);
  EXPECT_EQ(json["steps"], 20);
  EXPECT_NEAR(json["time"], 20 * json["step"].get<double>(), 1e-12);
  EXPECT_EQ(json["effects"], (nlohmann::json{"contacts, linear", "gravity, 0 0 -9.81 m/s^2"}));
  EXPECT_EQ(json["stages"].size(), 2u) << json["stages"];
  EXPECT_TRUE(json["stages"].contains("contacts"));
  EXPECT_TRUE(json["stages"].contains("motion"));
  for (const char* of_fluid : {"pores", "viscous_limit", "mean_pressure", "broken_bonds"})
    EXPECT_FALSE(json.contains(of_fluid)) << of_fluid;
  EXPECT_FALSE(json["energy"].contains("fluid"));
  EXPECT_GT(json["energy"]["weight"], 0);
}

TEST(RunCommand, RunsASceneWithFluid) {
  const TemporaryFile scene("piston.toml", wet);
  const auto json = answer(scene.path().string() + " --until 0.1");
  EXPECT_GE(json["time"], 0.1);
  EXPECT_LT(json["time"], 0.1 + json["step"].get<double>());
  EXPECT_GT(json["pores"], 30);
  EXPECT_GT(json["viscous_limit"], 0);
  EXPECT_LT(json["box"][2], 1);
  for (const char* stage : {"triangulate", "volume rates", "solve", "forces", "stable step"})
    EXPECT_TRUE(json["stages"].contains(stage)) << stage;
  EXPECT_GT(json["energy"]["loads"], 0);
  EXPECT_FALSE(answer(scene.path().string() + " --until 0.1 --scheme semi-implicit").contains("viscous_limit"));
}

TEST(RunCommand, SavesWhatItHasWhenItIsInterrupted) {
  const TemporaryFile scene("long.toml", grains + "[gravity]\nacceleration = [0, 0, -9.81]\n");
  const TemporaryFile saved("long.checkpoint", ""), history("long.csv", "");
  const auto stopped = [&](const std::string& arguments) {
    return run_program("timeout --preserve-status -s INT 2 " PFV_PROGRAM " run " + scene.path().string() + arguments);
  };
  const std::string save = " --save " + saved.path().string();
  const auto result = stopped(" --until 1e9 --json --history " + history.path().string() + save);
  expect_one_line(result, 130, "saved at");
  const auto steps = nlohmann::json::parse(result.output)["steps"].get<long long>();
  EXPECT_GT(steps, 0);
  EXPECT_EQ(lines_of(history.path().string()), 1 + steps / 100);
  const auto more =
      answer(scene.path().string() + fmt::format(" --steps {} --restart {}", steps + 1, saved.path().string()));
  EXPECT_EQ(more["steps"], steps + 1);
  expect_one_line(stopped(" --until 1e9"), 130, "without --save there is nothing to go on from");
}

TEST(RunCommand, PreparesAPackingToStartFrom) {
  const std::string pressed = grains + "[local_damping]\nshare = 0.3\n[walls]\nx_max = { stress = 1e3 }\n"
                                       "y_max = { stress = 1e3 }\nz_max = { stress = 1e3 }\n";
  const TemporaryFile scene("pressed.toml", pressed + "[run]\nsteps = 100000\nunbalanced = 1e-3\n");
  const TemporaryFile saved("pressed.checkpoint", "");
  const auto json = answer(scene.path().string() + " --save " + saved.path().string());
  EXPECT_LE(json["unbalanced_force"], 1e-3);
  EXPECT_LT(json["steps"], 100000);
  const TemporaryFile next("wet.toml", pressed + "[flow]\naxis = \"z\"\n");
  const int more = json["steps"].get<int>() + 5;
  const auto on =
      answer(next.path().string() + " --restart " + saved.path().string() + " --steps " + std::to_string(more));
  EXPECT_EQ(on["steps"], more);
  EXPECT_NEAR(on["box"][2].get<double>(), json["box"][2].get<double>(), 1e-3);
  expect_one_line(run(scene.path().string() + " --steps 200"), 3, "the grains did not come to rest in 200 steps");
}

TEST(RunCommand, SaysWhatIsOnAndWhatItCosts) {
  const TemporaryFile scene("piston.toml", wet + "[local_damping]\nshare = 0.3\n[run]\nsteps = 10\n");
  const auto result = run(scene.path().string());
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_EQ(result.error, ""); // no terminal, no progress
  for (const char* words : {"effect        contacts, linear\n", "effect        local damping, 0.3\n",
                            "effect        pressure and viscous force, 10 Pa s, explicit\n", "limit  ", "step  ",
                            "after 10 steps", "cpu seconds\n", "  triangulate", "  contacts"})
    EXPECT_NE(result.output.find(words), std::string::npos) << words << '\n' << result.output;
  EXPECT_EQ(result.output.find("gravity"), std::string::npos);
  EXPECT_EQ(result.output.find("goes on"), std::string::npos);
}

TEST(RunCommand, ShowsItsProgressOnATerminal) {
  const TemporaryFile scene("piston.toml", piston);
  const std::string command = std::string(PFV_PROGRAM) + " run " + scene.path().string() + " --steps 10";
  const auto shown = run_program("TERM=xterm script -qec '" + command + "' /dev/null < /dev/null");
  EXPECT_EQ(shown.exit_code, 0);
  EXPECT_NE(shown.output.find("[##..................]  10 %  t = "), std::string::npos) << shown.output;
  EXPECT_NE(shown.output.find(" s left"), std::string::npos) << shown.output;
  const auto dumb = run_program("TERM=dumb script -qec '" + command + "' /dev/null < /dev/null");
  EXPECT_EQ(dumb.output.find(" s left"), std::string::npos) << dumb.output;
}

TEST(RunCommand, WritesHistoryAndPacking) {
  const TemporaryFile scene("piston.toml", piston);
  const TemporaryFolder folder;
  const std::string history = folder.path() / "history.csv", packing = folder.path() / "packing.txt";
  const auto json =
      answer(scene.path().string() + " --steps 20 --every 5 --history " + history + " --packing " + packing);
  EXPECT_EQ(lines_of(history), 1 + 4);
  EXPECT_TRUE(pfv::read_text(history).starts_with("time,size_x,size_y,size_z,"));
  EXPECT_EQ(lines_of(packing), 1 + 30);
  const auto again = run_program(std::string(PFV_PROGRAM) + " permeability " + packing + " --json");
  EXPECT_EQ(again.exit_code, 0) << again.error;
  EXPECT_EQ(nlohmann::json::parse(again.output)["spheres"], 30);
}

TEST(RunCommand, GoesOnFromWhereItWasSaved) {
  const TemporaryFile scene("piston.toml", wet + "[run]\nstep = 1e-3\nuntil = 1\n");
  const TemporaryFolder folder;
  const std::string half = folder.path() / "half", rest = folder.path() / "rest";
  const std::string whole_packing = folder.path() / "whole.txt", packing = folder.path() / "parts.txt";
  // Saved at 0.05 s on the way, where the one that goes on starts.
  const auto whole =
      answer(scene.path().string() + " --steps 90 --save-every 0.0495 --save " + rest + " --packing " + whole_packing);
  answer(scene.path().string() + " --steps 50 --save " + half);
  const auto parts = answer(scene.path().string() + " --steps 90 --restart " + half + " --packing " + packing);
  EXPECT_EQ(parts["steps"], 90);
  EXPECT_EQ(parts["time"], whole["time"]);
  EXPECT_EQ(parts["mean_pressure"], whole["mean_pressure"]);
  EXPECT_EQ(parts["energy"], whole["energy"]);
  EXPECT_EQ(pfv::read_text(packing), pfv::read_text(whole_packing));
  const auto done = answer(scene.path().string() + " --steps 90 --restart " + rest);
  EXPECT_EQ(done["steps"], 90);
  EXPECT_EQ(done["energy"], whole["energy"]);
  EXPECT_EQ(done["unbalanced_force"], whole["unbalanced_force"]);
  const auto text = run(scene.path().string() + " --steps 60 --restart " + half).output;
  EXPECT_NE(text.find("goes on       from 0.05 s after 50 steps\n"), std::string::npos) << text;
}

TEST(RunCommand, KeepsTheLastCheckpointOfARunThatFails) {
  const TemporaryFile scene("fast.toml", wet + "[run]\nstep = 0.03\n"); // beyond the limit
  const TemporaryFolder folder;
  const std::string file = folder.path() / "saved";
  const auto result = run(scene.path().string() + " --steps 10000 --save-every 0.03 --save " + file);
  expect_one_line(result, 3, "left stability at");
  EXPECT_NE(result.error.find("; saved at "), std::string::npos) << result.error;
  EXPECT_TRUE(std::filesystem::exists(file));
}

TEST(RunCommand, RefusesFilesThatItCannotGoOnFrom) {
  const TemporaryFile scene("piston.toml", piston), more("more.toml", grains + "[grains]\ndensity = 1000\n");
  const TemporaryFolder folder;
  const std::string file = folder.path() / "saved";
  answer(scene.path().string() + " --steps 2 --save " + file);
  const auto says = [&](const TemporaryFile& of, const std::string& words) {
    expect_one_line(run(of.path().string() + " --steps 4 --restart " + file), 2, words);
  };
  says(more, file + ": the checkpoint is of other grains: mass of sphere");
  std::filesystem::resize_file(file, 1000);
  says(scene, file + ": truncated");
  std::ofstream(file) << "something else\n";
  says(scene, file + ": not a checkpoint of pfv run");
  std::filesystem::remove(file);
  says(scene, file + ": cannot be read: No such file");
}

TEST(RunCommand, RefusesBadOptionsInOneLine) {
  const TemporaryFile scene("piston.toml", piston);
  const auto says = [&](const std::string& options, const std::string& words) {
    expect_one_line(run(scene.path().string() + " " + options), 2, words);
  };
  says("", "how long the scene runs is not said: --steps, --until, or steps or until in [run]");
  says("--steps 0", "--steps \"0\" must be 1 or more");
  says("--steps -3", "--steps \"-3\" must be 1 or more");
  says("--steps ten", "ten");
  says("--until 0", "--until \"0\" must be above 0");
  says("--until -1", "--until \"-1\" must be above 0");
  says("--until nan", "--until \"nan\" must be above 0");
  says("--steps 5 --every 0", "--every");
  says("--steps 5 --every -2", "--every");
  says("--steps 5 --scheme magic", "--scheme \"magic\" is not one of explicit, semi-implicit");
  says("--steps 5 --history /nowhere/h.csv", "--history \"/nowhere/h.csv\" cannot be written");
  says("--steps 5 --packing /nowhere/p.txt", "--packing \"/nowhere/p.txt\" cannot be written");
  says("--steps 5 --save /nowhere/saved", "checkpoint \"/nowhere/saved\" cannot be written");
  says("--steps 5 --save-every 0.1", "--save");
  says("--steps 5 --save /tmp/saved --save-every 0", "--save-every \"0\" must be above 0");
  says("--steps 5 --wind 3", "--wind");
  expect_one_line(run("nowhere.toml --steps 5"), 2, "nowhere.toml");
}

TEST(RunCommand, RefusesBadScenesInOneLine) {
  const auto says = [](const std::string& text, const std::string& words) {
    const TemporaryFile scene("bad.toml", text);
    const auto result = run(scene.path().string() + " --steps 5");
    expect_one_line(result, 2, words);
    EXPECT_NE(result.error.find(scene.path().parent_path().string()), std::string::npos) << result.error;
    EXPECT_EQ(result.output, "");
  };
  says(grains + "colour = 3\n", "colour");
  says(grains + "[wind]\nspeed = 1\n", "gravity"); // among what is allowed
  says(grains + "friction = -0.1\n", "friction \"-0.1\" must be at least 0");
  says(grains + "[fluid]\nviscosity = 1\n", "[fluid] needs [flow] or [faces]");
  says(grains + "[compressible_fluid]\nbulk_modulus = 1\n", "[compressible_fluid] needs [flow] or [faces]");
  says(grains + "[walls]\nz_max = \"loose\"\n", "must be \"fixed\", { velocity = m/s } or { stress = Pa, mass = kg }");
  says(grains + "[walls]\nz_max = { stress = -1 }\n", "stress \"-1\" must be at least 0");
  says(grains + "[walls]\nz_max = { stress = 1, mass = 0 }\n", "mass \"0\" must be above 0");
  says(grains + "[flow]\naxis = \"z\"\n[pfv]\nsolver = \"amg\"\n", "solver");
  says(grains + "[run]\nsteps = 1.5\n", "steps");
  says(grains + "[flow]\naxis = \"z\"\n[faces]\nz_min = { pressure = 1 }\n", "at most one of [flow] and [faces]");
  says("[grains]\ndensity = 1\n", "packing");
  says("[packing]\nfile = \"nowhere.txt\"\n", "nowhere.txt");
  says("[packing\n", "bad.toml:1");
}

TEST(RunCommand, RefusesAFluidThatNothingLetsOut) {
  const TemporaryFile scene("closed.toml", grains + "[faces]\nz_min = \"slip\"\n");
  expect_one_line(run(scene.path().string() + " --steps 5"), 2, "level");
  const TemporaryFile pumped("pumped.toml", grains + "[faces]\nz_min = { pressure = 0 }\nz_max = { flux = 1 }\n");
  expect_one_line(run(pumped.path().string() + " --steps 5"), 2, "not at a flux");
}

} // namespace
