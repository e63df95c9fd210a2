#include "pfv/problem/text.hpp"
#include "studies/runner/row_store.hpp"
#include "tests/studies/study_process.hpp"
#include "tests/studies/study_text.hpp"
#include "tests/studies/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <algorithm>

// What was stored and is no longer what it was, and a disk that has no room for more: a failed row with the cause, the
// rest done, and all of it repaired by the next run.
namespace {

using studies::Row;
using studies::Status;

class Damage : public ::testing::Test {
protected:
  void SetUp() override { folder_.write("study.toml", study_text); }
  StudyOutput run(std::vector<std::string> arguments = {}, const std::map<std::string, std::string>& environment = {},
                  std::optional<std::size_t> largest_file = std::nullopt) {
    arguments.insert(arguments.begin(), {"run", folder_.path().string()});
    return study(arguments, environment, largest_file);
  }
  std::filesystem::path work() const { return folder_.path() / "work"; }
  std::vector<Row> rows() const { return studies::read_rows(work() / "rows.csv"); }
  std::filesystem::path answer(const Row& row) const { return work() / "answers" / (row.key + ".json"); }

  TemporaryFolder folder_;
};

void write(const std::filesystem::path& file, const std::string& text) {
  std::ofstream(file, std::ios::binary) << text;
}

TEST_F(Damage, AStoredAnswerThatCannotBeReadIsAFailedRow) {
  ASSERT_EQ(run().exit_code, 0);
  const auto before = rows();
  const std::string whole = pfv::read_text(answer(before[1]));
  const std::pair<std::string, std::string> damages[] = {
      {whole.substr(0, whole.size() / 2), "damaged"}, {"", "damaged"}, {"{}", "damaged"}};
  for (const auto& [text, words] : damages) {
    write(answer(before[1]), text);
    // A report alone says so too.
    const StudyOutput report = study({"report", folder_.path().string()});
    EXPECT_EQ(report.exit_code, 0) << report.err;
    EXPECT_NE(pfv::read_text(work() / "report.md").find(words), std::string::npos) << text;

    EXPECT_EQ(run().exit_code, 1);
    const Row lost = rows().back();
    EXPECT_EQ(lost.key, before[1].key);
    EXPECT_EQ(lost.status, Status::failed);
    EXPECT_NE(lost.message.find(words), std::string::npos) << lost.message;
    EXPECT_EQ(run().exit_code, 1); // it stands
    EXPECT_EQ(run({"--retry-failed"}).exit_code, 0);
    EXPECT_EQ(rows().back().status, Status::answered);
    EXPECT_EQ(rows().back().permeability, before[1].permeability);
  }
  std::filesystem::remove(answer(before[0]));
  EXPECT_EQ(run().exit_code, 1);
  EXPECT_NE(rows().back().message.find("gone"), std::string::npos) << rows().back().message;
  EXPECT_EQ(run({"--retry-failed"}).exit_code, 0);
}

TEST_F(Damage, ARowThatCannotBeReadIsDoneAgain) {
  ASSERT_EQ(run().exit_code, 0);
  const auto before = rows();
  std::string text = pfv::read_text(work() / "rows.csv");
  const auto status = text.find(",answered,", text.find(before[2].key));
  text.replace(status, 10, ",answXred,");
  write(work() / "rows.csv", text);
  const StudyOutput output = run();
  EXPECT_EQ(output.exit_code, 0) << output.err;
  EXPECT_NE(output.err.find("answXred"), std::string::npos) << output.err;
  EXPECT_EQ(pfv::read_text(work() / "rows.csv.damaged"), text);
  auto after = rows();
  ASSERT_EQ(after.size(), before.size());
  EXPECT_EQ(after.back().key, before[2].key);
  EXPECT_EQ(after[2], before[3]); // the others were left alone
}

TEST_F(Damage, ACaseThatCannotBeReadIsGeneratedAgain) {
  folder_.write("study.toml", std::string(study_text) + R"(
[[case]]
id = "generated"
packing = { generator = "nine_spheres" }
flow = { axis = "z" }
)");
  ASSERT_EQ(run().exit_code, 0);
  const auto before = rows();
  for (const auto& entry : std::filesystem::directory_iterator(work() / "cases"))
    if (entry.path().extension() == ".txt")
      std::filesystem::resize_file(entry.path(), 40);
  EXPECT_EQ(run().exit_code, 0);
  EXPECT_EQ(rows(), before);
}

TEST_F(Damage, AFullDiskIsAFailedRow) {
  folder_.write("study.toml", std::string(study_text) + R"(
[[case]]
id = "large"
packing = { generator = "random", spheres = 1000, solid_fraction = 0.3, seed = 1 }
flow = { axis = "z" }
)");
  run({}, {{"PFV_EXACT", "fail"}}); // the cases are stored
  ASSERT_EQ(run({"--retry-failed"}, {}, 20000).exit_code, 1);
  const auto all = rows();
  for (auto row = all.end() - 6; row != all.end(); ++row) {
    EXPECT_EQ(row->status, row->case_id == "large" ? Status::failed : Status::answered) << row->message;
    EXPECT_EQ(row->message.find("File too large") != std::string::npos, row->case_id == "large") << row->message;
  }
  EXPECT_EQ(run({"--retry-failed"}).exit_code, 0);
}

// The rows themselves have no room: the study stops and says so, and goes on from there.
TEST_F(Damage, ADiskWithoutRoomForRowsStopsTheStudy) {
  const StudyOutput output = run({}, {}, 1000);
  EXPECT_EQ(output.exit_code, 1);
  EXPECT_NE(output.err.find("File too large"), std::string::npos) << output.err;
  EXPECT_EQ(run().exit_code, 0);
  EXPECT_EQ(rows().size(), 4U);
}

TEST_F(Damage, APeerThatMayFailIsToldAndNoFault) {
  std::string text = study_text;
  folder_.write("study.toml", text.insert(text.find("mesh_sizes"), "may_fail = true\n"));
  const StudyOutput output = run({"--quick"}, {{"PFV_EXACT", "litter"}});
  EXPECT_EQ(output.exit_code, 0);
  EXPECT_NE(output.out.find("failed: one exact"), std::string::npos) << output.out;
}

TEST_F(Damage, WhatAKilledRunLeavesInItsTemporaryFolderIsRemoved) {
  EXPECT_EQ(run({"--quick"}, {{"PFV_EXACT", "litter"}}).exit_code, 1);
  EXPECT_FALSE(std::filesystem::exists(work() / "tmp") && !std::filesystem::is_empty(work() / "tmp"));
  std::filesystem::create_directories(work() / "tmp" / "of-a-killed-study");
  EXPECT_EQ(run({"--quick", "--retry-failed"}).exit_code, 0);
  EXPECT_FALSE(std::filesystem::exists(work() / "tmp" / "of-a-killed-study"));
}

} // namespace
