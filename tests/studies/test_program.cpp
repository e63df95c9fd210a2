#include "pfv/problem/text.hpp"
#include "studies/runner/row_store.hpp"
#include "tests/studies/study_process.hpp"
#include "tests/studies/study_text.hpp"
#include "tests/studies/temporary_folder.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace {

using studies::Row;
using studies::Status;

class Program : public ::testing::Test {
protected:
  StudyOutput run(std::vector<std::string> arguments = {}, const std::map<std::string, std::string>& environment = {}) {
    arguments.insert(arguments.begin(), {"run", folder_.path().string()});
    return study(arguments, environment);
  }
  std::vector<Row> rows() const { return studies::read_rows(folder_.path() / "work" / "rows.csv"); }
  void write_study(const std::string& text) { folder_.write("study.toml", text); }

  TemporaryFolder folder_;
};

std::string with(const std::string& what, const std::string& by) {
  std::string text = study_text;
  return text.replace(text.find(what), what.size(), by);
}

TEST_F(Program, AnswersAndReports) {
  write_study(study_text);
  const StudyOutput output = run();
  EXPECT_EQ(output.exit_code, 0) << output.err;
  ASSERT_EQ(rows().size(), 4U);
  for (const Row& row : rows()) {
    EXPECT_EQ(row.status, Status::answered) << row.message;
    EXPECT_EQ(row.repeats, 5); // each is over in no time
    EXPECT_GT(row.peak_memory_bytes, 0U);
    EXPECT_FALSE(row.commit.empty() || row.compiler.empty() || row.flags.empty() || row.machine.empty());
    EXPECT_TRUE(std::filesystem::exists(folder_.path() / "work" / "answers" / (row.key + ".json")));
  }
  const auto report = folder_.path() / "work" / "report.html";
  EXPECT_TRUE(output.out.ends_with("Report: " + report.string() + "\n"));
  EXPECT_NE(pfv::read_text(report).find("Does the harness work?"), std::string::npos);
  EXPECT_NE(pfv::read_text(folder_.path() / "work" / "report.md").find("Does the harness work?"), std::string::npos);
  EXPECT_EQ(output.out.find('\033'), std::string::npos) << "escape codes without a terminal";
  EXPECT_EQ(output.err.find('\033'), std::string::npos) << "escape codes without a terminal";
}

TEST_F(Program, SaysWhatTheReaderOfAPackingNoticed) {
  folder_.write("p.dump", "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n1\nITEM: BOX BOUNDS pp ff ff\n0 1\n0 1\n0 1\n"
                          "ITEM: ATOMS id x y z radius\n1 0.5 0.5 0.5 0.2\n");
  std::string text = study_text;
  const std::size_t second = text.rfind("packing = ");
  text.replace(second, text.find('\n', second) - second, "packing = { file = \"p.dump\" }");
  write_study(text);
  const StudyOutput output = run();
  EXPECT_EQ(output.exit_code, 0) << output.err;
  EXPECT_NE(output.err.find("two: "), std::string::npos) << output.err;
  EXPECT_NE(output.err.find("its box repeats along x"), std::string::npos) << output.err;
}

TEST(Run, AllStudiesTakeNothingThatIsForOne) {
  const StudyOutput output = study({"run", "all", "--only", "exact"});
  EXPECT_EQ(output.exit_code, 2);
  EXPECT_EQ(output.err, "study: all studies take no --only, --json and --work, which are for one\n");
}

TEST(Index, HasALineForEveryStudy) {
  const TemporaryFolder folder;
  const StudyOutput output = study({"index", "--to", folder.path().string()});
  EXPECT_EQ(output.exit_code, 0) << output.err;
  EXPECT_EQ(output.out, "Index: " + (folder.path() / "index.html").string() + "\n");
  const std::string page = pfv::read_text(folder.path() / "index.html");
  for (const char* name : {"agreement", "consolidation", "effects", "lattices", "permeability", "scaling", "table1"})
    EXPECT_NE(page.find(name), std::string::npos) << name;
}

TEST(Experiments, AreListedAndRefuseWhatTheyHaveNoUseFor) {
  const StudyOutput list = study({"list"});
  for (const char* name : {"consolidation", "immersed_settling", "stability", "uplift"})
    EXPECT_NE(list.out.find(name), std::string::npos) << name;
  const StudyOutput refused = study({"run", "uplift", "--only", "fake"});
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_EQ(refused.err, "study: uplift is one simulation: it takes --quick and --work only\n");
  const TemporaryFolder empty;
  const StudyOutput nothing = study({"report", "uplift", "--work", empty.path().string()});
  EXPECT_EQ(nothing.exit_code, 2);
  EXPECT_NE(nothing.err.find("has no report; `study run uplift` makes it"), std::string::npos) << nothing.err;
}

TEST_F(Program, ExtrapolatesToTheKnownAnswer) {
  write_study(study_text);
  const auto results = nlohmann::json::parse(run({"--json"}).out)["results"];
  ASSERT_EQ(results.size(), 2U);
  // k = 1 + 0.05 h^2 at h = 2 and 1: 1 at h = 0, and the bar is 1.25 times 0.05.
  EXPECT_NEAR(results[0]["permeability_m2"]["value"], 1, 1e-12);
  EXPECT_NEAR(results[0]["permeability_m2"]["error"], 1.25 * 0.05, 1e-12);
}

TEST_F(Program, DoesNothingTwiceUnlessFresh) {
  write_study(study_text);
  run();
  const auto before = rows();
  EXPECT_EQ(run().exit_code, 0);
  EXPECT_EQ(rows(), before);
  EXPECT_EQ(run({"--fresh", "--jobs", "2"}).exit_code, 0);
  EXPECT_EQ(rows().size(), before.size());
  EXPECT_NE(rows(), before);
}

TEST_F(Program, QuickDoesThePartMarkedSo) {
  write_study(study_text);
  EXPECT_EQ(run({"--quick"}).exit_code, 0);
  ASSERT_EQ(rows().size(), 2U);
  EXPECT_EQ(rows()[0].mesh_size, 4);
  EXPECT_EQ(rows()[1].mesh_size, 2);
}

TEST_F(Program, AMethodThatFailsIsAFailedRowAndExitCodeOne) {
  write_study(study_text);
  const std::pair<const char*, const char*> modes[] = {{"fail", "exact was asked to fail"},
                                                       {"throw", "exit code 1"},
                                                       {"crash", "signal 6"},
                                                       {"nonsense", "PFV_EXACT is 'nonsense'"}};
  for (const auto& [mode, words] : modes) {
    const StudyOutput output = run({"--quick", "--fresh"}, {{"PFV_EXACT", mode}});
    EXPECT_EQ(output.exit_code, 1) << mode;
    ASSERT_EQ(rows().size(), 2U) << mode;
    for (const Row& row : rows()) {
      EXPECT_EQ(row.status, Status::failed) << mode;
      EXPECT_NE(row.message.find(words), std::string::npos) << mode << ": " << row.message;
    }
    EXPECT_NE(output.out.find("failed"), std::string::npos) << mode;
  }
}

TEST_F(Program, AFailureStandsUntilARetryIsAskedFor) {
  write_study(study_text);
  run({"--quick"}, {{"PFV_EXACT", "fail"}});
  EXPECT_EQ(run({"--quick"}).exit_code, 1);
  EXPECT_EQ(rows().size(), 2U);
  EXPECT_EQ(run({"--quick", "--retry-failed"}).exit_code, 0);
  EXPECT_EQ(rows().size(), 4U);
}

TEST_F(Program, ARunThatTakesTooLongIsStopped) {
  write_study(with("[[method]]", "[budget]\nwall_seconds = 0.5\n[[method]]"));
  EXPECT_EQ(run({"--quick", "--jobs", "2"}, {{"PFV_EXACT", "slow"}}).exit_code, 1);
  ASSERT_EQ(rows().size(), 2U);
  EXPECT_NE(rows()[0].message.find("stopped after"), std::string::npos) << rows()[0].message;
}

TEST_F(Program, ARunThatTakesTooMuchMemoryFails) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "the sanitizer maps more memory than any limit";
#endif
  write_study(with("[[method]]", "[budget]\nmemory_bytes = 4e8\n[[method]]"));
  EXPECT_EQ(run({"--quick"}, {{"PFV_EXACT", "greedy"}}).exit_code, 1);
  ASSERT_EQ(rows().size(), 2U);
  EXPECT_NE(rows()[0].message.find("out of memory"), std::string::npos) << rows()[0].message;
  EXPECT_EQ(run({"--quick", "--retry-failed", "--memory-budget", "1e9"}, {{"PFV_EXACT", "greedy"}}).exit_code, 0);
}

TEST_F(Program, WhatIsOverBudgetIsNotRun) {
  write_study(study_text);
  EXPECT_EQ(run({"--quick", "--cpu-budget", "1e-9"}).exit_code, 0);
  EXPECT_EQ(run({"--quick", "--cpu-budget", "1e-9"}).exit_code, 0); // and not stored twice
  ASSERT_EQ(rows().size(), 2U);
  for (const Row& row : rows()) {
    EXPECT_EQ(row.status, Status::over_budget);
    EXPECT_NE(row.message.find("CPU s"), std::string::npos) << row.message;
    EXPECT_EQ(row.repeats, 0);
  }
  EXPECT_EQ(run({"--quick"}).exit_code, 0); // within the study's own budget
  EXPECT_EQ(rows().back().status, Status::answered);
}

TEST_F(Program, ACaseWithABudgetOfItsOwnLeavesThatOfTheOthers) {
  write_study(with("quick = true", "budget = { cpu_seconds = 1e-9 }"));
  EXPECT_EQ(run().exit_code, 0);
  ASSERT_EQ(rows().size(), 4U);
  for (const Row& row : rows())
    EXPECT_EQ(row.status, row.case_id == "one" ? Status::over_budget : Status::answered) << row.case_id;
  EXPECT_EQ(run({"--cpu-budget", "1"}).exit_code, 0); // which stands in for all of them
  ASSERT_EQ(rows().size(), 6U);
  EXPECT_EQ(rows().back().status, Status::answered);
}

TEST_F(Program, NewMeshSizesOfACaseLeaveStoredRowsAlone) {
  write_study(study_text);
  run();
  write_study(with("quick = true", "budget = { cpu_seconds = 9 }\nmesh_sizes = { exact = [2.0, 1.0, 0.5] }"));
  EXPECT_EQ(run().exit_code, 0);
  ASSERT_EQ(rows().size(), 5U);
  EXPECT_EQ(rows().back().mesh_size, 0.5);
}

TEST_F(Program, WhatAMethodDoesNotCoverIsSaid) {
  write_study(with("flow = { axis = \"z\" }", "faces = { x_min = { pressure = 0 }, z_max = { pressure = 1 } }"));
  EXPECT_EQ(run({"--quick"}).exit_code, 0);
  ASSERT_EQ(rows().size(), 2U);
  EXPECT_EQ(rows()[0].status, Status::not_covered);
  EXPECT_NE(rows()[0].message.find("along one axis"), std::string::npos);
}

TEST_F(Program, WhatIsUnavailableIsSaid) {
  write_study(with("[[method]]", "[[method]]\nname = \"absent\"\n[[method]]"));
  const StudyOutput output = run({"--only", "absent"});
  EXPECT_EQ(output.exit_code, 0);
  ASSERT_EQ(rows().size(), 2U); // a method that is not there has no meshes either: one row for each case
  for (const Row& row : rows()) {
    EXPECT_EQ(row.status, Status::unavailable);
    EXPECT_EQ(row.message, "not in this build");
  }
}

TEST_F(Program, ReportsAgainFromStoredRowsAndPublishes) {
  write_study(study_text);
  EXPECT_EQ(study({"report", folder_.path().string()}).exit_code, 2); // nothing stored
  run();
  std::filesystem::remove(folder_.path() / "work" / "report.md");
  EXPECT_EQ(study({"report", folder_.path().string(), "--publish"}).exit_code, 0);
  EXPECT_TRUE(std::filesystem::exists(folder_.path() / "work" / "report.md"));
  for (const char* page : {"report.md", "report.html"})
    EXPECT_EQ(pfv::read_text(folder_.path() / "results" / page), pfv::read_text(folder_.path() / "work" / page));
  EXPECT_EQ(studies::read_rows(folder_.path() / "results" / "rows.csv"), rows());
}

TEST_F(Program, ComparesOnACaseAndOnAPackingFile) {
  const auto packing = folder_.write("packing.txt", "# box 0 0 0 1 1 1\n0.5 0.5 0.5 0.25\n");
  const std::vector<std::string> rest{"--methods", "exact",        "--reference",
                                      "exact",     "--mesh-sizes", "2,1",
                                      "--json",    "--work",       (folder_.path() / "work").string()};
  std::vector<std::string> on_packing{"compare", packing.string(), "--axis", "x"};
  on_packing.insert(on_packing.end(), rest.begin(), rest.end());
  const StudyOutput first = study(on_packing);
  EXPECT_EQ(first.exit_code, 0) << first.err;
  EXPECT_EQ(nlohmann::json::parse(first.out)["results"].size(), 1U);

  const auto file = folder_.write("case.toml", "packing = { file = \"packing.txt\" }\nflow = { axis = \"x\" }\n");
  std::vector<std::string> on_case{"compare", file.string()};
  on_case.insert(on_case.end(), rest.begin(), rest.end());
  EXPECT_EQ(study(on_case).exit_code, 0);
  EXPECT_EQ(rows().size(), 2U); // the same question: nothing was run again

  on_case.insert(on_case.begin() + 2, {"--axis", "y"}); // the command line wins
  EXPECT_EQ(study(on_case).exit_code, 0);
  EXPECT_EQ(rows().size(), 4U);
  on_case[3] = "w";
  EXPECT_EQ(study(on_case).exit_code, 2);
}

TEST_F(Program, BadInputIsExitCodeTwoAndOneLine) {
  write_study(with("title =", "titel = 1\ntitle ="));
  const StudyOutput output = run();
  EXPECT_EQ(output.exit_code, 2);
  EXPECT_NE(output.err.find("study.toml:2"), std::string::npos) << output.err;
  EXPECT_EQ(study({"run", "no_such_study"}).exit_code, 2);
  EXPECT_EQ(study({"run"}).exit_code, 2);
  EXPECT_EQ(study({"nonsense"}).exit_code, 2);
  EXPECT_EQ(study({"compare", "/nowhere.toml"}).exit_code, 2);
  EXPECT_EQ(study({"run", folder_.path().string(), "--jobs", "0"}).exit_code, 2);
}

TEST_F(Program, HelpListAndMethodsSucceed) {
  EXPECT_EQ(study({"--help"}).exit_code, 0);
  EXPECT_NE(study({"list"}).out.find("table1"), std::string::npos);
  const StudyOutput methods = study({"methods"});
  EXPECT_EQ(methods.exit_code, 0);
  EXPECT_NE(methods.out.find("exact"), std::string::npos);
}

TEST_F(Program, AnswersOneQuestionByItself) {
  const auto file = folder_.write("case.toml", "packing = { generator = \"nine_spheres\" }\nflow = { axis = \"z\" }\n");
  const auto out = folder_.path() / "answer.json";
  const std::vector<std::string> arguments{"answer", "--case", file.string(), "--method",
                                           "exact",  "--out",  out.string()};
  EXPECT_EQ(study(arguments).exit_code, 0);
  EXPECT_TRUE(nlohmann::json::parse(pfv::read_text(out)).contains("sphere_forces"));
  EXPECT_EQ(study(arguments, {{"PFV_EXACT", "fail"}}).exit_code, 3);
  EXPECT_EQ(study(arguments, {{"PFV_EXACT", "nonsense"}}).exit_code, 2);
}

TEST_F(Program, OnATerminalThereIsABarAndNoColourWhenNotWanted) {
  write_study(study_text);
  const std::vector<std::string> arguments{"run", folder_.path().string(), "--quick", "--fresh"};
  const std::string plain = study_on_terminal(arguments, {{"TERM", "xterm"}, {"NO_COLOR", "1"}});
  EXPECT_NE(plain.find("\r\033[K"), std::string::npos); // the line that is rewritten
  EXPECT_NE(plain.find(" s of about "), std::string::npos) << plain;
  EXPECT_EQ(plain.find("\033[1m"), std::string::npos);
  const std::string coloured = study_on_terminal(arguments, {{"TERM", "xterm"}, {"NO_COLOR", ""}});
  EXPECT_NE(coloured.find("\033[1m"), std::string::npos);
}

} // namespace
