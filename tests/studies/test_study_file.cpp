#include "studies/runner/study_file.hpp"

#include "pfv/problem/error.hpp"
#include "studies/runner/case_store.hpp"
#include "tests/studies/study_text.hpp"
#include "tests/studies/temporary_folder.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace {

using studies::read_study;

std::string replaced(const std::string& text, const std::string& what, const std::string& by) {
  const auto at = text.find(what);
  EXPECT_NE(at, std::string::npos) << what;
  return text.substr(0, at) + by + text.substr(at + what.size());
}

// The message of the InputError, or nothing.
std::string refusal(const std::string& text) {
  const TemporaryFolder folder;
  try {
    read_study(folder.write("study.toml", text));
  } catch (const pfv::InputError& error) {
    return error.what();
  }
  return "";
}

void expect_refused(const std::string& what, const std::string& by, std::initializer_list<const char*> words) {
  const std::string message = refusal(replaced(study_text, what, by));
  EXPECT_NE(message.find("study.toml:"), std::string::npos) << message;
  for (const char* word : words)
    EXPECT_NE(message.find(word), std::string::npos) << "'" << word << "' is not in: " << message;
}

TEST(StudyFile, ReadsWhatIsThereAndDefaultsTheRest) {
  const TemporaryFolder folder;
  const auto study = read_study(folder.write("some_study/study.toml", study_text));
  EXPECT_EQ(study.name, "some_study");
  EXPECT_EQ(study.title, "A study");
  EXPECT_EQ(study.reference, "exact");
  ASSERT_EQ(study.methods.size(), 1U);
  EXPECT_EQ(study.methods[0].mesh_sizes, (std::vector{2.0, 1.0}));
  ASSERT_EQ(study.cases.size(), 2U);
  EXPECT_EQ(study.cases[0].label, "one");
  EXPECT_EQ(study.cases[0].quick_methods, std::vector<std::string>{"exact"});
  EXPECT_TRUE(study.cases[1].quick_methods.empty());
  EXPECT_EQ(study.cases[0].budget, studies::Budget{});
  EXPECT_TRUE(study.cases[0].mesh_sizes.empty());
}

TEST(StudyFile, ReadsTolerancesBudgetAndPublishedFigures) {
  const TemporaryFolder folder;
  const auto study = read_study(folder.write(
      "study.toml",
      replaced(replaced(study_text, "[[method]]", "[tolerance]\nforces = 0.1\n[budget]\ncpu_seconds = 7\n[[method]]\n"),
               "quick = true", "published = [{ method = \"exact\", unknowns = 45 }]")));
  EXPECT_EQ(study.tolerance, (studies::Tolerance{0.05, 0.1}));
  for (const studies::StudyCase& one : study.cases)
    EXPECT_EQ(one.budget, (studies::Budget{.cpu_seconds = 7}));
  ASSERT_EQ(study.cases[0].published.size(), 1U);
  EXPECT_EQ(study.cases[0].published[0], (studies::PublishedFigure{"exact", 45, std::nullopt}));
}

TEST(StudyFile, ACaseTakesFromTheStudyWhatItsOwnBudgetDoesNotName) {
  const TemporaryFolder folder;
  const auto study = read_study(
      folder.write("study.toml",
                   replaced(replaced(study_text, "[[method]]", "[budget]\ncpu_seconds = 7\n[[method]]"), "quick = true",
                            "budget = { memory_bytes = 1e10, wall_seconds = 60 }\nquick = true\nseeds = [1, 2]")));
  ASSERT_EQ(study.cases.size(), 3U);
  for (const std::size_t seed : {0, 1})
    EXPECT_EQ(study.cases[seed].budget, (studies::Budget{7, 1e10, 60}));
  EXPECT_EQ(study.cases[2].budget, (studies::Budget{.cpu_seconds = 7}));
}

TEST(StudyFile, ACaseMayHaveMeshSizesOfItsOwn) {
  const TemporaryFolder folder;
  const auto study =
      read_study(folder.write("study.toml", replaced(study_text, "quick = true", "mesh_sizes = { exact = [3, 1.5] }")));
  EXPECT_EQ(study.cases[0].mesh_sizes, (std::map<std::string, std::vector<double>>{{"exact", {3, 1.5}}}));
  EXPECT_TRUE(study.cases[1].mesh_sizes.empty());
}

TEST(StudyFile, ReadsWhatScalingAsksFor) {
  const TemporaryFolder folder;
  const auto with = [&](const std::string& section) {
    return read_study(folder.write("study.toml", replaced(study_text, "[[method]]", section + "\n[[method]]"))).scaling;
  };
  EXPECT_FALSE(with(""));
  EXPECT_EQ(*with("[scaling]"), studies::Scaling{});
  EXPECT_EQ(*with("[scaling]\ncompared_with = \"exact\"\nunit_stage = \"solve\""),
            (studies::Scaling{"exact", "solve"}));
}

TEST(StudyFile, ReadsWhatACurveAsksFor) {
  const TemporaryFolder folder;
  const auto with = [&](const std::string& section) {
    return read_study(folder.write("study.toml", replaced(study_text, "[[method]]", section + "\n[[method]]"))).curve;
  };
  EXPECT_FALSE(with(""));
  EXPECT_EQ(*with("[curve]\nlines = [\"exact\"]\ncompared_with = \"exact\""), (studies::Curve{{"exact"}, "exact"}));
}

TEST(StudyFile, ACaseWithSeedsIsAsManyOfOneLabel) {
  const TemporaryFolder folder;
  const auto study = read_study(
      folder.write("study.toml", replaced(study_text, "quick = true", "curve = \"c\"\nquick = true\nseeds = [7, 8]")));
  ASSERT_EQ(study.cases.size(), 3U);
  EXPECT_EQ(study.cases[0].id, "one_7");
  EXPECT_EQ(study.cases[1].id, "one_8");
  EXPECT_EQ(study.cases[1].label, "one");
  EXPECT_EQ(study.cases[1].curve, "c");
  EXPECT_EQ(study.cases[1].quick_methods, study.cases[0].quick_methods);
  EXPECT_NE(study.cases[0].toml.find("seed = 7"), std::string::npos) << study.cases[0].toml;
  EXPECT_NE(study.cases[1].toml.find("seed = 8"), std::string::npos) << study.cases[1].toml;
}

TEST(StudyFile, RefusesUnknownKeysNamingTheValidOnes) {
  expect_refused("title =", "titel = 1\ntitle =", {"study.toml:2", "titel", "title", "question"});
  expect_refused("mesh_sizes = [2", "mesh_size = 1\nmesh_sizes = [2", {"mesh_size", "quick_mesh_sizes"});
  expect_refused("quick = true", "quik = true", {"quik", "quick", "packing"});
  expect_refused("[[method]]", "[budget]\nseconds = 1\n[[method]]", {"seconds", "cpu_seconds", "memory_bytes"});
  expect_refused("quick = true", "budget = { seconds = 1 }", {"seconds", "cpu_seconds, memory_bytes, wall_seconds"});
  expect_refused("[[method]]", "[tolerance]\nforce = 1\n[[method]]", {"force", "permeability, forces, pressures"});
  expect_refused("[[method]]", "[scaling]\nunit = 1\n[[method]]", {"unit", "compared_with", "unit_stage"});
  expect_refused("[[method]]", "[curve]\nline = 1\n[[method]]", {"line", "lines, compared_with"});
  expect_refused("quick = true", "published = [{ dofs = 1 }]", {"dofs", "unknowns"});
}

TEST(StudyFile, RefusesUnknownNamesNamingTheValidOnes) {
  expect_refused("name = \"exact\"", "name = \"exakt\"", {"exakt", "absent", "exact"});
  expect_refused("reference = \"exact\"", "reference = \"other\"", {"reference", "other", "exact"});
  expect_refused("[[method]]", "[scaling]\ncompared_with = \"other\"\n[[method]]", {"compared_with", "other", "exact"});
  expect_refused("quick = true", "quick = [\"other\"]", {"quick", "other", "exact"});
  expect_refused("quick = true", "methods = [\"other\"]", {"methods", "other", "exact"});
}

TEST(StudyFile, RefusesMeshSizesOfMethodsThatTheCaseDoesNotAskOrThatHaveNoMesh) {
  const std::string two = replaced(study_text, "[[method]]", "[[method]]\nname = \"closed_form\"\n[[method]]");
  const auto refused = [&](const std::string& keys) { return refusal(replaced(two, "quick = true", keys)); };
  for (const char* name : {"exakt", "closed_form"}) {
    const std::string message = refused(fmt::format("mesh_sizes = {{ {} = [1] }}", name));
    EXPECT_NE(message.find("study.toml:"), std::string::npos) << message;
    EXPECT_NE(message.find(fmt::format("mesh_sizes \"{}\" must be of a method with a mesh", name)), std::string::npos)
        << message;
    EXPECT_TRUE(message.ends_with("that the case asks: exact")) << message;
  }
  const std::string message = refused("methods = [\"closed_form\"]\nmesh_sizes = { exact = [1] }");
  EXPECT_TRUE(message.ends_with("\"exact\" must be of a method with a mesh that the case asks: it asks none"))
      << message;
}

TEST(StudyFile, RefusesBadValues) {
  expect_refused("quick = true", "seeds = [0.5]", {"seeds", "0.5", "whole"});
  expect_refused("quick = true", "seeds = [-1]", {"seeds", "-1", "0 or more"});
  expect_refused("[2.0, 1.0]", "[1.0, 2.0]", {"mesh_sizes", "coarse to fine"});
  expect_refused("[2.0, 1.0]", "[1.0, 1.0]", {"coarse to fine"});
  expect_refused("[2.0, 1.0]", "[0]", {"larger than zero"});
  expect_refused("[2.0, 1.0]", "[]", {"at least one"});
  expect_refused("quick = true", "mesh_sizes = { exact = [1.0, 2.0] }", {"mesh_sizes", "1.0, 2.0", "coarse to fine"});
  expect_refused("quick = true", "mesh_sizes = { exact = [2.0, -1.0] }", {"mesh_sizes", "-1.0", "larger than zero"});
  expect_refused("quick = true", "mesh_sizes = { exact = 1.5 }", {"mesh_sizes", "1.5", "list"});
  expect_refused("quick = true", "mesh_sizes = [1.5]", {"mesh_sizes", "1.5", "table"});
  expect_refused("quick = true", "budget = 7", {"budget", "7", "table"});
  expect_refused("quick = true", "budget = { cpu_seconds = 0 }", {"cpu_seconds", "0", "larger than zero"});
  expect_refused("id = \"one\"", "id = \"../one\"", {"../one", "letters"});
  expect_refused("id = \"one\"", "id = \"two\"", {"two", "twice"});
  expect_refused("title = \"A study\"", "title = 3", {"title", "3"});
  expect_refused("title = \"A study\"", "", {"title"});
  expect_refused("[[case]]", "[[case", {"not TOML"});
}

TEST(StudyFile, LeadsTroubleWithAQuestionByThePlaceInTheStudy) {
  const TemporaryFolder folder;
  const auto study = read_study(folder.write("study.toml", replaced(study_text, "axis = \"z\"", "axis = \"up\"")));
  try {
    studies::store_case(study.cases[0], folder.path() / "cases", "");
    FAIL();
  } catch (const pfv::InputError& error) {
    const std::string message = error.what();
    EXPECT_NE(message.find("study.toml:11"), std::string::npos) << message;
    EXPECT_NE(message.find("up"), std::string::npos) << message;
  }
}

TEST(StudyFile, PackingFilesAreRelativeToTheStudy) {
  const TemporaryFolder folder;
  folder.write("packing.txt", "# box 0 0 0 1 1 1\n0.5 0.5 0.5 0.25\n");
  const auto text = replaced(
      study_text, "packing = { box = [[0, 0, 0], [1, 1, 1]], spheres = [[0.3, 0.4, 0.5, 0.2], [0.7, 0.6, 0.5, 0.1]] }",
      "packing = { file = \"packing.txt\" }");
  const auto study = read_study(folder.write("study.toml", text));
  const auto stored = studies::store_case(study.cases[0], folder.path() / "cases", "");
  EXPECT_EQ(stored.problem.packing.spheres.size(), 1U);
  EXPECT_EQ(pfv::digest(pfv::read_case(stored.file)), stored.digest);
}

TEST(StudyFile, PackingFilesMayHaveAScaleAndABox) {
  const TemporaryFolder folder;
  folder.write("packing.txt", "#format x_y_z_r\n1 1 1 0.5\n");
  const auto text = replaced(
      study_text, "packing = { box = [[0, 0, 0], [1, 1, 1]], spheres = [[0.3, 0.4, 0.5, 0.2], [0.7, 0.6, 0.5, 0.1]] }",
      "packing = { file = \"packing.txt\", scale = 0.5, box = [[0, 0, 0], [2, 2, 2]] }");
  const auto study = read_study(folder.write("study.toml", text));
  const auto stored = studies::store_case(study.cases[0], folder.path() / "cases", "");
  EXPECT_EQ(stored.problem.packing, (pfv::Packing{pfv::Box{}, {{pfv::Vec3(0.5, 0.5, 0.5), 0.25}}}));
}

TEST(StudyFile, StoresAQuestionAsItWasWithItsSpheresInAFileBeside) {
  const TemporaryFolder folder;
  const auto text =
      replaced(study_text, "flow = { axis = \"z\" }", "flow = { axis = \"z\" }\nfluid = { viscosity = 0.1 }");
  const auto study = read_study(folder.write("study.toml", text));
  const auto stored = studies::store_case(study.cases[0], folder.path() / "cases", "");
  EXPECT_EQ(stored.problem.name, "one");
  EXPECT_EQ(stored.problem.fluid.viscosity, 0.1);
  EXPECT_EQ(stored.problem.packing.spheres.at(1).radius, 0.1);
  auto spheres = stored.file;
  EXPECT_EQ(pfv::read_packing(spheres.replace_extension(".txt")), stored.problem.packing);
}

} // namespace
