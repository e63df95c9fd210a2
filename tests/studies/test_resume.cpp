#include "pfv/problem/text.hpp"
#include "studies/runner/row_store.hpp"
#include "tests/studies/study_process.hpp"
#include "tests/studies/study_text.hpp"
#include "tests/studies/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <functional>
#include <set>
#include <thread>

namespace {

using namespace std::chrono_literals;
using studies::read_rows;
using studies::Row;

bool wait_for(const std::function<bool()>& condition, std::chrono::milliseconds limit = 10s) {
  const auto end = std::chrono::steady_clock::now() + limit;
  while (!condition()) {
    if (std::chrono::steady_clock::now() > end)
      return false;
    std::this_thread::sleep_for(5ms);
  }
  return true;
}

// Whether any process has this text in its command line.
bool a_process_mentions(const std::string& text) {
  for (const auto& entry : std::filesystem::directory_iterator("/proc")) {
    std::ifstream in(entry.path() / "cmdline");
    if (std::string((std::istreambuf_iterator<char>(in)), {}).find(text) != std::string::npos)
      return true;
  }
  return false;
}

std::size_t different_keys(const std::vector<Row>& rows) {
  std::set<std::string> keys;
  for (const Row& row : rows)
    keys.insert(row.key);
  return keys.size();
}

TEST(Resume, KeepsWhatWasDoneBeforeAKillAndDoesTheRest) {
  const TemporaryFolder folder;
  folder.write("study.toml", study_text);
  const auto rows_file = folder.path() / "work" / "rows.csv";
  ASSERT_EQ(study({"run", folder.path().string()}).exit_code, 0);
  const auto done = read_rows(rows_file);

  folder.write("study.toml", study_text + R"(
[[case]]
id = "three"
packing = { box = [[0, 0, 0], [1, 1, 1]], spheres = [[0.5, 0.5, 0.5, 0.3]] }
flow = { axis = "y" }
)");
  {
    RunningStudy running({"run", folder.path().string()}, {{"PFV_EXACT", "slow"}}, folder.path() / "log");
    ASSERT_TRUE(wait_for([&] { return a_process_mentions((folder.path() / "work" / "answers").string()); }));
    ASSERT_TRUE(wait_for([&] { return pfv::read_text(folder.path() / "log").find("started") != std::string::npos; }));
    running.kill();
  }
  EXPECT_EQ(read_rows(rows_file), done);
  EXPECT_TRUE(wait_for([&] { return !a_process_mentions(folder.path().string()); })) << "a run outlived its study";

  ASSERT_EQ(study({"run", folder.path().string()}).exit_code, 0);
  const auto all = read_rows(rows_file);
  ASSERT_EQ(all.size(), 6U);
  EXPECT_TRUE(std::equal(done.begin(), done.end(), all.begin())) << "a finished row was changed or repeated";
  EXPECT_EQ(different_keys(all), 6U);
}

TEST(Resume, KilledAgainAndAgainLosesAndRepeatsNothing) {
  const TemporaryFolder folder;
  std::string text = study_text;
  text.replace(text.find("[2.0, 1.0]"), 10, "[5, 4, 3, 2, 1]");
  folder.write("study.toml", text);
  const auto rows_file = folder.path() / "work" / "rows.csv";
  std::vector<Row> before;
  for (int kills = 0; kills < 6; ++kills) {
    RunningStudy running({"run", folder.path().string()}, {}, folder.path() / "log");
    // Somewhere in the middle of a row, each time elsewhere.
    wait_for([&] { return running.ended() || read_rows(rows_file).size() > before.size(); });
    std::this_thread::sleep_for(std::chrono::milliseconds(17 * kills));
    running.kill();
    const auto after = read_rows(rows_file);
    ASSERT_GE(after.size(), before.size());
    ASSERT_TRUE(std::equal(before.begin(), before.end(), after.begin()));
    before = after;
  }
  ASSERT_EQ(study({"run", folder.path().string()}).exit_code, 0);
  const auto all = read_rows(rows_file);
  EXPECT_EQ(all.size(), 10U);
  EXPECT_EQ(different_keys(all), 10U);
}

} // namespace
