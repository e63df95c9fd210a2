// The README's commands work as they stand: every line of its `sh` blocks that calls a program of ours is run in the
// project's folder. The two scripts that install, build and run everything are what runs this test. So do its scenes.
#include "readme/numbers.hpp"
#include "support/run_program.hpp"
#include "support/temporary_file.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace {

const std::string programs = "build/release/bin/";

/// The lines of each block of a language.
std::vector<std::vector<std::string>> blocks(const std::string& language) {
  std::ifstream readme(PROJECT_FOLDER "/README.md");
  std::vector<std::vector<std::string>> found;
  bool in_block = false;
  for (std::string line; std::getline(readme, line);) {
    if (line.starts_with("```")) {
      in_block = line == "```" + language;
      if (in_block)
        found.emplace_back();
    } else if (in_block)
      found.back().push_back(line);
  }
  return found;
}

std::vector<std::string> commands() {
  std::vector<std::string> found;
  for (const auto& block : blocks("sh"))
    for (const std::string& line : block)
      if (line.starts_with(programs))
        found.push_back(line.substr(programs.size()));
  return found;
}

std::vector<std::string> scenes() {
  std::vector<std::string> found;
  for (const auto& block : blocks("toml"))
    if (std::ranges::find(block, "[run]") != block.end()) {
      found.emplace_back();
      for (const std::string& line : block)
        found.back() += line + '\n';
    }
  return found;
}

/// m^2, by the original implementation; 0 where it has no number.
double peer_permeability(const std::string& packing) {
  std::ifstream table(PROJECT_FOLDER "/tests/data/peer_permeability.csv");
  for (std::string line; std::getline(table, line);)
    if (line.starts_with(packing + ","))
      return std::stod(line.substr(line.find(',', packing.size() + 1) + 1));
  return 0;
}

TEST(Readme, CommandsRun) {
  const auto lines = commands();
  EXPECT_GE(lines.size(), 4u);
  for (const std::string& line : lines) {
    const auto result =
        pfv::testing::run_program("cd " PROJECT_FOLDER " && PFV_MESH_CACHE=" MESH_CACHE " " PROGRAM_FOLDER "/" + line);
    EXPECT_EQ(result.exit_code, 0) << line << '\n' << result.output << result.error;
  }
}

TEST(Readme, ScenesRun) {
  const auto texts = scenes();
  EXPECT_GE(texts.size(), 1u);
  for (const std::string& text : texts) {
    const pfv::testing::TemporaryFile scene("scene.toml", text);
    const auto result = pfv::testing::run_program(PROGRAM_FOLDER "/pfv run " + scene.path().string() + " --steps 1");
    EXPECT_EQ(result.exit_code, 0) << text << result.error;
  }
}

/// The table of what wall factors do: packing, k of the original (tests/data/peer_permeability.csv), ours with its
/// factors, ours with mirror walls, differences to the first in brackets.
TEST(Readme, WallFactorsDoWhatItSays) {
  std::ifstream readme(PROJECT_FOLDER "/README.md");
  std::size_t rows = 0;
  for (std::string line; std::getline(readme, line);) {
    if (!line.starts_with("| `"))
      continue;
    const std::string name = line.substr(3, line.find('`', 3) - 3);
    const std::string packing = PROJECT_FOLDER "/tests/data/" + name + ".txt";
    const auto numbers = readme::numbers_in(line.substr(line.find(" |", 3)));
    if (!std::filesystem::exists(packing) || numbers.size() < 2)
      continue;
    const auto k = [&](const std::string& walls) {
      const auto ran = pfv::testing::run_program(PROGRAM_FOLDER "/pfv permeability " + packing +
                                                 " --axis y --json --walls " + walls);
      return nlohmann::json::parse(ran.output).at("permeability").get<double>();
    };
    const double original = peer_permeability(name), ours[] = {k("original"), k("mirror")};
    std::vector<double> expected{ours[0], ours[1]};
    if (original > 0)
      expected = {original, ours[0], 100 * (ours[0] / original - 1), ours[1], 100 * (ours[1] / original - 1)};
    ASSERT_EQ(numbers.size(), expected.size()) << line;
    for (std::size_t i = 0; i < numbers.size(); ++i)
      EXPECT_NEAR(expected[i], numbers[i].value, 0.5001 * numbers[i].step) << numbers[i].text << " of " << name;
    ++rows;
  }
  EXPECT_EQ(rows, 4u);
}

} // namespace
