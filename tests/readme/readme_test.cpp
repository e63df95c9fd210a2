// The README's commands work as they stand: every line of its `sh` blocks that calls a program of ours is run in the
// project's folder. The two scripts that install, build and run everything are what runs this test.
#include "support/run_program.hpp"

#include <fstream>
#include <gtest/gtest.h>
#include <string>
#include <vector>

namespace {

const std::string programs = "build/release/bin/";

std::vector<std::string> commands() {
  std::ifstream readme(PROJECT_FOLDER "/README.md");
  std::vector<std::string> found;
  bool in_block = false;
  for (std::string line; std::getline(readme, line);) {
    if (line.starts_with("```"))
      in_block = line == "```sh";
    else if (in_block && line.starts_with(programs))
      found.push_back(line.substr(programs.size()));
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

} // namespace
