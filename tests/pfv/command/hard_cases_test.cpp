// What the original implementation (FlowEngine of YADE 2023.02a) answers with NaN and exit code 0, crashes on, accepts
// in silence or gets negative. Here each is answered in finite numbers or refused in one line.
#include "pfv/problem/generate.hpp"
#include "support/run_program.hpp"
#include "support/temporary_file.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <sstream>

using namespace pfv;
using pfv::testing::run_program;
using pfv::testing::TemporaryFile;

namespace {

std::string text(const Packing& packing) {
  std::ostringstream out;
  write_packing(packing, out);
  return out.str();
}

void expect_finite(const nlohmann::json& value, const std::string& name) {
  EXPECT_FALSE(value.is_null()) << name; // how JSON writes what is not finite
  EXPECT_TRUE(!value.is_number() || std::isfinite(value.get<double>())) << name;
  if (!value.is_structured())
    return;
  for (const auto& [key, child] : value.items())
    expect_finite(child, key);
}

nlohmann::json answer(const Packing& packing, const std::string& options = "") {
  const TemporaryFile file("packing.txt", text(packing));
  const auto result =
      run_program(std::string(PFV_PROGRAM) + " permeability " + file.path().string() + " --json " + options);
  EXPECT_EQ(result.exit_code, 0) << result.error;
  EXPECT_EQ(result.error, "");
  const auto json = nlohmann::json::parse(result.output);
  expect_finite(json, "answer");
  EXPECT_GT(json["permeability"].get<double>(), 0);
  EXPECT_NEAR(json["flux_in"].get<double>() / json["flux_out"].get<double>(), 1, 1e-8);
  return json;
}

void expect_refusal(const std::string& packing, const std::string& words) {
  const TemporaryFile file("packing.txt", packing);
  const auto result = run_program(std::string(PFV_PROGRAM) + " permeability " + file.path().string());
  EXPECT_EQ(result.exit_code, 2) << packing;
  EXPECT_EQ(result.output, "");
  EXPECT_EQ(std::ranges::count(result.error, '\n'), 1) << result.error;
  EXPECT_NE(result.error.find(words), std::string::npos) << result.error;
}

TEST(HardCases, ExactLattices) {
  for (const auto lattice : {Lattice::simple_cubic, Lattice::bcc, Lattice::fcc})
    for (const double looseness : {1.0, .8})
      answer(lattice_packing(lattice, looseness * touching_solid_fraction(lattice), 3));
  answer(nine_spheres());
}

TEST(HardCases, Fcc864) {
  Packing packing{{}, {}}; // 6^3 cells of four whole spheres
  for (int x = 0; x < 6; ++x)
    for (int y = 0; y < 6; ++y)
      for (int z = 0; z < 6; ++z)
        for (const Vec3& at : {Vec3(0, 0, 0), Vec3(.5, .5, 0), Vec3(.5, 0, .5), Vec3(0, .5, .5)})
          packing.spheres.push_back({(Vec3(x, y, z) + at + Vec3(.25, .25, .25)) / 6, .25 * std::sqrt(2.0) / 6});
  const auto json = answer(packing);
  EXPECT_EQ(json["spheres"], 864);
  EXPECT_GT(json["contracted_throats"], 0);
}

TEST(HardCases, OneTwoAndALayerOfSpheres) {
  answer({{}, {{{.4, .5, .6}, .3}}});
  answer({{}, {{{.3, .5, .5}, .2}, {{.7, .5, .5}, .2}}});
  Packing layer{{{0, 0, 0}, {5, 5, 1}}, {}};
  for (int x = 0; x < 5; ++x)
    for (int y = 0; y < 5; ++y)
      layer.spheres.push_back({{x + .5, y + .5, .5}, .5});
  answer(layer);
  answer(layer, "--axis x");
}

TEST(HardCases, SpheresInsideOthersAreReportedHidden) {
  const auto json = answer({{}, {{{.5, .5, .5}, .4}, {{.55, .5, .5}, .05}, {{.2, .2, .2}, .1}}});
  EXPECT_EQ(json["hidden_spheres"], nlohmann::json::array({1}));
}

TEST(HardCases, HeavyOverlapStaysPositive) {
  for (const double growth : {1.05, 1.1, 1.3}) {
    Packing packing = random_packing({.spheres = 200, .solid_fraction = .5, .radius_ratio = 1.35, .seed = 1});
    for (auto& sphere : packing.spheres)
      sphere.radius *= growth;
    answer(packing);
  }
}

TEST(HardCases, SizeRatioOfTwenty) {
  for (const double fraction : {.3, .45})
    answer(random_packing({.spheres = 300, .solid_fraction = fraction, .radius_ratio = 20, .seed = 4}));
}

TEST(HardCases, ATenthOfAMillionPoresOnAPressureWall) {
  Packing packing{{{0, 0, 0}, {220, 220, 2}}, {}};
  for (int x = 0; x < 220; ++x)
    for (int y = 0; y < 220; ++y)
      for (int z = 0; z < 2; ++z)
        packing.spheres.push_back({{x + .5 + .1 * std::sin(7. * x + 3 * y), y + .5 + .1 * std::sin(5. * y + x + z),
                                    z + .5 + .05 * std::sin(11. * x * y)},
                                   .35});
  const auto json = answer(packing);
  EXPECT_GT(json["pores"].get<int>() - json["unknowns"].get<int>(), 180'000); // of both walls
}

TEST(HardCases, WhatNoOneCanAnswerIsRefused) {
  const std::string box = "# box 0 0 0 1 1 1\n";
  expect_refusal(box, "sphere");
  expect_refusal(box + "1.5 0.5 0.5 0.1\n", "1.5");
  expect_refusal(box + "0.5 0.5 0.5 nan\n", "nan");
  expect_refusal(box + "0.5 0.5 0.5 0\n", "\"0\"");
  expect_refusal(box + "0.5 0.5 0.5 -0.1\n", "-0.1");
  expect_refusal(box + "0.5 0.5 0.5 0.1\n0.5 0.5 0.5 0.1\n", "every other sphere");
  expect_refusal(box + "0.5 0.5 inf 0.1\n", "inf");
}

TEST(HardCases, SpheresThatCloseAllThroatsLeaveNoWay) {
  std::string text = "# box 0 0 0 2 2 2\n";
  for (const char* at : {"0.5 0.5 0.5", "0.5 0.5 1.5", "0.5 1.5 0.5", "0.5 1.5 1.5", "1.5 0.5 0.5", "1.5 0.5 1.5",
                         "1.5 1.5 0.5", "1.5 1.5 1.5"})
    text += std::string(at) + " 0.75\n";
  const TemporaryFile file("sealed.txt", text);
  const auto result = run_program(std::string(PFV_PROGRAM) + " permeability " + file.path().string());
  EXPECT_EQ(result.exit_code, 0) << result.error;
  EXPECT_NE(result.output.find("\npermeability  0.000000e+00 m^2\n"), std::string::npos) << result.output;
  EXPECT_NE(result.output.find("\nno way        for the fluid: "), std::string::npos) << result.output;
}

TEST(HardCases, AFlowWithoutAPressureIsRefused) {
  const TemporaryFile file("closed.toml", "[packing]\nbox = [[0, 0, 0], [1, 1, 1]]\n"
                                          "spheres = [[0.5, 0.5, 0.5, 0.3]]\n[faces]\nx_min = \"slip\"\n");
  const auto result = run_program(std::string(PFV_PROGRAM) + " permeability " + file.path().string());
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_EQ(std::ranges::count(result.error, '\n'), 1) << result.error;
  EXPECT_NE(result.error.find("pressure"), std::string::npos) << result.error;
}

} // namespace
