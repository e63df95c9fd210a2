#include "studies/document/markdown.hpp"
#include "studies/motion/stability/original.hpp"
#include "studies/motion/stability/stability.hpp"

#include "reference/yade/program.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <stdexcept>
#include <unistd.h>

namespace studies {
namespace {

const Say silent = [](const std::string&, double) {};

Trial answering(const char* name, double value) {
  return {"Some", name, true, [=] { return Measured{{{"off", value, 0, 1}}, "2 closed", {1, value}}; }};
}

Trial crashing() {
  return {"Some", "crashing", true, []() -> Measured {
            std::signal(SIGSEGV, SIG_DFL); // not to a sanitizer
            std::raise(SIGSEGV);
            return {};
          }};
}

TEST(Stability, ACrashIsARowAndNotTheEnd) {
  const auto rows = tried_all({answering("first", 0.5), crashing(), answering("last", 0.25)}, silent);
  ASSERT_EQ(rows.size(), 3u);
  EXPECT_TRUE(rows[0].holds());
  EXPECT_EQ(rows[1].outcome, "killed by signal 11 (Segmentation fault)");
  EXPECT_FALSE(rows[1].holds());
  EXPECT_EQ(rows[2].outcome, done);
  EXPECT_EQ(rows[2].ours.remarks, "2 closed");
  EXPECT_EQ(rows[2].ours.plotted, (std::vector{1, 0.25}));
  const ExperimentReport report = stability_report(rows);
  EXPECT_FALSE(report.holds);
  const std::string text = to_markdown(report.page);
  EXPECT_NE(text.find("Segmentation fault"), text.npos) << text;
  EXPECT_NE(text.find("2 of 3"), text.npos) << text;
}

TEST(Stability, WhatThrowsOrDoesNotEndIsARow) {
  const TrialRow thrown = tried({"Some", "throwing", true, []() -> Measured { throw std::runtime_error("no luck"); }});
  EXPECT_EQ(thrown.outcome, "exit code 1: no luck");
  const TrialRow late = tried({"Some", "late", true,
                               []() -> Measured {
                                 while (true)
                                   pause();
                               }},
                              0.1);
  EXPECT_EQ(late.outcome, "stopped after 0.1 s");
}

TEST(Stability, AValueOutsideOfItsBoundOrNoNumberDoesNotHold) {
  EXPECT_TRUE(stability_report({tried(answering("inside", 1))}).holds);
  EXPECT_FALSE(stability_report({tried(answering("inside", 1)), tried(answering("outside", 1.01))}).holds);
  EXPECT_FALSE(tried(answering("nan", std::nan(""))).holds());
}

TEST(Stability, CasesOfEveryKindComeOutAndHold) {
  std::vector<Trial> trials = hard_cases(true);
  std::erase_if(trials, [](const Trial& trial) { return trial.group.starts_with("Explicit steps above"); }); // long
  std::vector<std::string> groups;
  for (Trial& trial : trials) {
    trial.theirs = nullptr;
    groups.push_back(trial.group);
  }
  groups.erase(std::unique(groups.begin(), groups.end()), groups.end());
  EXPECT_GE(groups.size(), 10u);
  for (const TrialRow& row : tried_all(trials, silent)) {
    EXPECT_EQ(row.outcome, done) << row.group << ": " << row.name;
    EXPECT_FALSE(row.ours.measures.empty()) << row.group << ": " << row.name;
    for (const Measure& measure : row.ours.measures)
      EXPECT_TRUE(measure.holds()) << row.group << ": " << row.name << ": " << measure.what << ' ' << measure.value;
  }
}

TEST(Stability, TellsWhatBecameOfTheOriginal) {
  EXPECT_EQ(in_words("yade: killed by signal 11 (Segmentation fault); its last words: a | b"),
            "crashed with signal 11 (Segmentation fault)");
  EXPECT_EQ(in_words("yade: stopped after 120 s; its last words: "), "no answer in 120 s");
  EXPECT_EQ(in_words("FlowEngine's flux through a pressure face is not a finite number"), "nan, exit code 0");
  EXPECT_EQ(in_words("yade left no reply: cannot open"), "no answer, exit code 0");
  EXPECT_EQ(in_words("yade: exit code 1; its last words: File: a | Explanation: b"), "exit code 1: Explanation: b");
}

TEST(Stability, AsksTheOriginalWhereItIsInstalled) {
  pfv::Case problem;
  problem.packing.spheres = {{{.5, .5, .5}, .3}};
  problem.faces = pfv::flow_along(pfv::Axis::z);
  const Theirs theirs = original_flow(problem);
  EXPECT_EQ(theirs.words == not_installed, reference::yade::missing_program().has_value());
  EXPECT_FALSE(theirs.words.empty());
}

} // namespace
} // namespace studies
