#include "reference/method.hpp"

#include "pfv/problem/error.hpp"
#include "pfv/problem/generate.hpp"
#include "support/message_of.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>
#include <string_view>

namespace reference {
namespace {

pfv::Case shut_case() {
  pfv::Case problem;
  problem.packing = pfv::nine_spheres();
  return problem;
}

TEST(Methods, HaveNamesOfTheirOwnAndOneLineEach) {
  std::set<std::string> names;
  for (const auto& method : methods()) {
    EXPECT_TRUE(names.insert(method->name()).second) << method->name();
    EXPECT_FALSE(method->description().empty()) << method->name();
    EXPECT_EQ(method->description().find('\n'), std::string::npos) << method->name();
  }
}

TEST(Methods, ComeInTheOrderOfTheTables) {
  std::vector<std::string> expected{"stokes_fem", "openfoam", "openfoam_snappy", "closed_form", "exact"};
  std::vector<std::string> found;
  for (const auto& method : methods())
    if (std::ranges::count(expected, method->name()))
      found.push_back(method->name());
  EXPECT_EQ(found, expected);
}

TEST(Methods, AreFoundByName) {
  EXPECT_EQ(find_method("closed_form").name(), "closed_form");
}

TEST(Methods, AnUnknownNameIsAnErrorThatNamesTheValidOnes) {
  const auto message = pfv::testing::message_of<pfv::InputError>([] { find_method("opnfoam"); });
  EXPECT_NE(message.find("'opnfoam'"), std::string::npos) << message;
  for (const auto& method : methods())
    EXPECT_NE(message.find(method->name()), std::string::npos) << message;
}

/// The folders of what the sources below a folder include from this project.
std::set<std::string> included_below(const std::filesystem::path& folder) {
  std::set<std::string> folders;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    if (entry.path().extension() != ".cpp" && entry.path().extension() != ".hpp")
      continue;
    std::ifstream source(entry.path());
    for (std::string line; std::getline(source, line);)
      if (line.starts_with("#include \""))
        folders.insert(std::filesystem::path(line.substr(10, line.find('"', 10) - 10)).parent_path());
  }
  return folders;
}

TEST(Methods, AreBuiltFromAllThatTheyInclude) {
  const std::filesystem::path project = std::filesystem::path(TEST_DATA) / ".." / "..";
  for (const auto& method : methods()) {
    const auto folders = method->built_from();
    const auto is_named = [&](const std::string& included) {
      return included == "pfv" || included == "reference" ||
             std::ranges::any_of(folders, [&](const std::string& folder) {
               return included == folder || included.starts_with(folder + "/");
             });
    };
    for (const std::string& folder : folders)
      for (const std::string& included : included_below(project / folder))
        EXPECT_TRUE(is_named(included)) << method->name() << " is built from " << folder << ", which includes "
                                        << included;
  }
}

TEST(Methods, TheFakeSaysThatItIsOne) {
  EXPECT_NE(find_method("exact").description().find("fake"), std::string::npos);
}

TEST(Methods, SayWhyTheyDoNotCoverABoxWithoutAnyPressure) {
  for (const auto& method : methods())
    if (!method->unavailable()) {
      const auto reason = method->not_covered(shut_case());
      ASSERT_TRUE(reason) << method->name();
      EXPECT_GT(reason->size(), 10U) << method->name();
      pfv::Clock clock;
      EXPECT_ANY_THROW(method->solve(shut_case(), {}, clock)) << method->name();
    }
}

pfv::Case case_with(const pfv::FaceCondition& below) {
  pfv::Case problem = shut_case();
  problem.faces = pfv::flow_along(pfv::Axis::z);
  problem.faces[index(pfv::Face::z_min)] = below;
  return problem;
}

TEST(Methods, ThatMeshKnowOnlyWallsAndPressuresAndSayWhatElseIsAsked) {
  std::vector<std::pair<pfv::Case, std::string>> asked{
      {case_with(pfv::Flux{1}), "an imposed flux on z_min"},
      {case_with(pfv::PressureProfile{pfv::Axis::x, {{0, 0}}}), "a pressure profile on z_min"},
      {case_with(pfv::Periodic{1}), "a periodic face on z_min"},
      {case_with(pfv::Pressure{0}), "a pressure at a point"}};
  asked.back().first.pressure_points = {{pfv::Vec3(0.5, 0.5, 0.5), 1}};
  for (const char* name : {"stokes_fem", "openfoam", "openfoam_snappy"})
    for (const auto& [problem, words] : asked)
      EXPECT_TRUE(find_method(name).unavailable() ||
                  (std::string_view(name) == "stokes_fem" && words.starts_with("a periodic face")) ||
                  find_method(name).not_covered(problem).value_or("").starts_with(words))
          << name << ' ' << words;
  for (const auto& [problem, words] : asked) {
    EXPECT_TRUE(find_method("closed_form").not_covered(problem)) << words;
    const bool periodic = pfv::periodic_axes(problem.faces) != pfv::PeriodicAxes{};
    EXPECT_NE(find_method("exact").not_covered(problem).has_value(), periodic) << words;
  }
}

} // namespace
} // namespace reference
