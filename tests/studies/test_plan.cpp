#include "studies/runner/plan.hpp"

#include "pfv/problem/error.hpp"
#include "studies/runner/study_run.hpp"
#include "tests/studies/example_row.hpp"
#include "tests/studies/study_text.hpp"
#include "tests/studies/temporary_folder.hpp"

#include <gtest/gtest.h>

namespace {

using studies::plan;
using studies::PlannedRun;

studies::Study example_study() {
  const TemporaryFolder folder;
  return studies::read_study(folder.write("study.toml", study_text));
}

TEST(Plan, GoesByCaseThenFromCoarseToFine) {
  EXPECT_EQ(
      plan(example_study(), {}),
      (std::vector<PlannedRun>{{"one", "exact", 2}, {"one", "exact", 1}, {"two", "exact", 2}, {"two", "exact", 1}}));
}

TEST(Plan, QuickHasItsOwnCasesAndMeshes) {
  EXPECT_EQ(plan(example_study(), {true, {}}), (std::vector<PlannedRun>{{"one", "exact", 4}, {"one", "exact", 2}}));
}

TEST(Plan, MeshSizesOfACaseStandInForTheMethods) {
  studies::Study study = example_study();
  study.cases.front().mesh_sizes["exact"] = {3, 1.5, 0.5};
  EXPECT_EQ(plan(study, {}), (std::vector<PlannedRun>{{"one", "exact", 3},
                                                      {"one", "exact", 1.5},
                                                      {"one", "exact", 0.5},
                                                      {"two", "exact", 2},
                                                      {"two", "exact", 1}}));
  EXPECT_EQ(plan(study, {true, {}}), plan(example_study(), {true, {}})); // which are not the quick ones
}

TEST(Plan, AMethodWithoutAMeshRunsOnce) {
  studies::Study study = example_study();
  study.methods.front().name = "closed_form";
  for (studies::StudyCase& one : study.cases)
    one.methods = {"closed_form"};
  EXPECT_EQ(plan(study, {}), (std::vector<PlannedRun>{{"one", "closed_form", 1}, {"two", "closed_form", 1}}));
}

TEST(Plan, RefusesAMethodTheStudyDoesNotAsk) {
  EXPECT_THROW(plan(example_study(), {false, {"absent"}}), pfv::InputError);
}

TEST(RowsOfPlan, TakesTheNewestRowOfTheNewestQuestion) {
  studies::Row old_question = example_row("exact", 2);
  old_question.case_digest = "older";
  studies::Row first = example_row("exact", 1);
  first.status = studies::Status::failed;
  const studies::Row second = example_row("exact", 1);
  const std::vector<PlannedRun> runs{{"one", "exact", 2}, {"one", "exact", 1}, {"two", "exact", 1}};
  EXPECT_EQ(studies::rows_of_plan(runs, {old_question, first, second}), std::vector{second});
}

} // namespace
