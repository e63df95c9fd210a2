// The pages on how to add a method, a study and an effect work as they stand: they are followed, one after the other,
// in a copy of the project. What is built there is what was built here but for a few files, and comes from ccache, see
// the project's CMakeLists.txt.
#include "pages/page.hpp"

#include "support/run_program.hpp"
#include "support/temporary_folder.hpp"

#include <chrono>
#include <gtest/gtest.h>
#include <iostream>

namespace {

using pages::Step;

/// The commands are those of the optimised build; here they are of this one.
std::string for_this_build(std::string command) {
  const std::string release = "release";
  for (auto at = command.find(release); at != command.npos; at = command.find(release, at + 1))
    command.replace(at, release.size(), PRESET);
  return command;
}

void follow(const std::string& page, const std::filesystem::path& project) {
  SCOPED_TRACE(page);
  const auto steps = pages::steps_of(project / page);
  std::size_t commands = 0, expected = 0;
  std::string printed;
  for (const Step& step : steps) {
    if (step.language == "sh")
      for (const std::string& line : step.lines) {
        const auto start = std::chrono::steady_clock::now();
        const auto result = pfv::testing::run_program("cd '" + project.string() + "' && " + for_this_build(line));
        std::cout << std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() << " s: " << line
                  << std::endl;
        ASSERT_EQ(result.exit_code, 0) << line << '\n' << result.output << result.error;
        printed += result.output + result.error;
        ++commands;
      }
    else if (step.language.empty())
      for (const std::string& line : step.lines) {
        EXPECT_NE(printed.find(line), printed.npos) << line << "\nis not in\n" << printed;
        ++expected;
      }
    else if (!step.file.empty())
      ASSERT_NO_THROW(pages::apply(step, project)) << step.file;
    else
      ADD_FAILURE() << "a block of " << step.language << " is no file's";
  }
  EXPECT_GE(commands, 3u);
  EXPECT_GE(expected, 1u);
}

TEST(Pages, WorkAsTheyStand) {
  const pfv::testing::TemporaryFolder folder;
  const auto project = folder.path() / "project";
  pages::copy_project(PROJECT_FOLDER, project);
  for (const char* page :
       {"reference/ADDING_A_METHOD.md", "studies/ADDING_A_STUDY.md", "pfv/simulation/ADDING_AN_EFFECT.md"})
    follow(page, project);
}

TEST(Pages, ADiffChangesWhatStandsThereOnce) {
  EXPECT_EQ(pages::changed("a\nb\nc\n", {" a", "-b", "+d"}), "a\nd\nc\n");
  EXPECT_EQ(pages::changed("a\nb\n", {"+c"}), "a\nb\nc\n");
  EXPECT_EQ(pages::changed("ab\nb\n", {"-b", "+c"}), "ab\nc\n");
  EXPECT_THROW(pages::changed("a\n", {" b", "+c"}), std::runtime_error);
  EXPECT_THROW(pages::changed("a\na\n", {" a", "+c"}), std::runtime_error);
}

} // namespace
