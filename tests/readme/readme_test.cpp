// The README's commands work as they stand: every line of its `sh` blocks that calls a program of ours is run in the
// project's folder. The two scripts that install, build and run everything are what runs this test. So do its scenes.
#include "support/run_program.hpp"
#include "support/temporary_file.hpp"

#include <algorithm>
#include <fstream>
#include <gtest/gtest.h>
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

} // namespace
