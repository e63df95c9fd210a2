#include "meshing/child_process.hpp"

#include "support/temporary_folder.hpp"

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <sstream>
#include <sys/wait.h>
#include <system_error>
#include <thread>
#include <unistd.h>

namespace {

using meshing::ChildOptions;
using meshing::ChildResult;
using meshing::last_lines;
using meshing::run_child;
using meshing::run_in_child;

/// Not counting a zombie, which an orphan stays until the machine's init looks at it.
bool is_running(pid_t process) {
  std::ifstream in("/proc/" + std::to_string(process) + "/stat");
  std::string text;
  std::getline(in, text);
  const auto name_end = text.rfind(')');
  return name_end != std::string::npos && text.substr(name_end + 2, 1) != "Z";
}

bool ends(pid_t process) {
  for (int i = 0; i < 500 && is_running(process); ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  return !is_running(process);
}

class ChildProcess : public testing::Test {
protected:
  /// Runs a line of shell; its output goes to log().
  ChildResult shell(const std::string& script, ChildOptions options = {}) const {
    options.log = log();
    return run_child({"/bin/sh", "-c", script}, options);
  }
  std::filesystem::path log() const { return folder_.path() / "log"; }
  std::string output() const {
    std::ifstream in(log());
    std::ostringstream text;
    text << in.rdbuf();
    return text.str();
  }

  pfv::testing::TemporaryFolder folder_;
};

TEST_F(ChildProcess, ReportsTheExitCode) {
  EXPECT_TRUE(shell("exit 0").succeeded());
  const auto result = shell("exit 3");
  EXPECT_FALSE(result.succeeded());
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_EQ(result.signal, 0);
  EXPECT_FALSE(result.timed_out);
  EXPECT_EQ(result.how_it_ended(), "exit code 3");
}

TEST_F(ChildProcess, ReportsTheSignal) {
  const auto result = shell("kill -SEGV $$");
  EXPECT_FALSE(result.succeeded());
  EXPECT_EQ(result.exit_code, -1);
  EXPECT_EQ(result.signal, SIGSEGV);
  EXPECT_EQ(result.how_it_ended(), "killed by signal 11 (Segmentation fault)");
}

TEST_F(ChildProcess, GetsNoMoreMemoryThanItsLimit) {
  const std::string takes_a_gigabyte = "dd if=/dev/zero of=/dev/null bs=1G count=1";
  EXPECT_TRUE(shell(takes_a_gigabyte).succeeded()) << output();
  EXPECT_FALSE(shell(takes_a_gigabyte, {.memory_limit = 100'000'000}).succeeded());
  EXPECT_NE(output().find("memory"), std::string::npos) << output();
}

TEST_F(ChildProcess, StopsAtTheWallLimitAndTakesTheWholeGroup) {
  const auto result = shell("sleep 60 & echo $!; wait", {.wall_limit = 0.3});
  EXPECT_TRUE(result.timed_out);
  EXPECT_FALSE(result.succeeded());
  EXPECT_GE(result.wall_seconds, 0.3);
  EXPECT_LT(result.wall_seconds, 10);
  EXPECT_EQ(result.how_it_ended().substr(0, 14), "stopped after ");
  const pid_t grandchild = std::stoi(output());
  EXPECT_TRUE(ends(grandchild));
}

TEST_F(ChildProcess, EndsWhatTheProgramLeavesBehind) {
  const auto result = shell("sleep 60 & echo $!");
  EXPECT_TRUE(result.succeeded());
  const pid_t orphan = std::stoi(output());
  EXPECT_TRUE(ends(orphan));
}

TEST_F(ChildProcess, CountsTheCpuSecondsOfGrandchildrenToo) {
  const std::string burn = "i=0; while [ $i -lt 100000 ]; do i=$((i+1)); done";
  EXPECT_GT(shell(burn).cpu_seconds, 0.01);
  EXPECT_GT(shell("sh -c '" + burn + "'; true").cpu_seconds, 0.01); // all of it the grandchild's
  EXPECT_LT(shell("sleep 0.5").cpu_seconds, 0.2);
}

TEST_F(ChildProcess, MeasuresPeakMemory) {
  const auto little = shell("exec true");
  const auto much = shell("exec dd if=/dev/zero of=/dev/null bs=200M count=1");
  EXPECT_GT(much.peak_memory_bytes, std::size_t{190} << 20);
  EXPECT_LT(little.peak_memory_bytes, std::size_t{100} << 20);
}

TEST_F(ChildProcess, AddsToTheEnvironment) {
  setenv("CHILD_PROCESS_TEST_KEPT", "kept", 1);
  setenv("CHILD_PROCESS_TEST_CHANGED", "old", 1);
  shell("echo $CHILD_PROCESS_TEST_KEPT $CHILD_PROCESS_TEST_CHANGED",
        {.environment = {{"CHILD_PROCESS_TEST_CHANGED", "new value; not a command"}}});
  EXPECT_EQ(output(), "kept new value; not a command\n");
}

TEST_F(ChildProcess, RunsInItsFolderWithBothStreamsInTheLog) {
  shell("pwd -P; echo to errors >&2", {.working_folder = folder_.path()});
  EXPECT_EQ(output(), std::filesystem::canonical(folder_.path()).string() + "\nto errors\n");
}

TEST_F(ChildProcess, HasNoInput) {
  EXPECT_TRUE(shell("! read line").succeeded());
}

TEST_F(ChildProcess, PassesArgumentsUntouched) {
  const auto result = run_child({"printf", "%s|", "a b", "$HOME", "'"}, {.log = log()});
  EXPECT_TRUE(result.succeeded());
  EXPECT_EQ(output(), "a b|$HOME|'|");
}

TEST_F(ChildProcess, ThrowsWhenTheProgramCannotBeStarted) {
  try {
    run_child({"/no/such/program"});
    FAIL() << "started a program that does not exist";
  } catch (const std::system_error& error) {
    EXPECT_EQ(error.code().value(), ENOENT);
    EXPECT_NE(std::string(error.what()).find("/no/such/program"), std::string::npos);
  }
  EXPECT_THROW(shell("true", {.working_folder = folder_.path() / "none"}), std::system_error);
  EXPECT_THROW(run_child({"true"}, {.log = folder_.path() / "none" / "log"}), std::system_error);
  EXPECT_THROW(run_child({}), std::system_error);
}

TEST_F(ChildProcess, LeavesNoZombie) {
  shell("exit 1");
  shell("sleep 60", {.wall_limit = 0.05});
  EXPECT_THROW(run_child({"/no/such/program"}), std::system_error);
  EXPECT_EQ(waitpid(-1, nullptr, WNOHANG), -1);
  EXPECT_EQ(errno, ECHILD);
}

TEST_F(ChildProcess, DiesWithItsParent) {
  const pid_t parent = fork();
  if (parent == 0) {
    shell("echo $$; exec sleep 60");
    _exit(0);
  }
  for (int i = 0; i < 200 && output().empty(); ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  const pid_t grandchild = std::stoi(output());
  EXPECT_TRUE(is_running(grandchild));
  kill(parent, SIGKILL);
  waitpid(parent, nullptr, 0);
  EXPECT_TRUE(ends(grandchild));
}

TEST_F(ChildProcess, LastLinesSkipsEmptyOnes) {
  shell("printf 'one\\ntwo\\n\\nthree \\n\\nfour\\n\\n'");
  EXPECT_EQ(last_lines(log()), "two | three | four");
  EXPECT_EQ(last_lines(log(), 1), "four");
  EXPECT_EQ(last_lines(folder_.path() / "none"), "");
}

TEST_F(ChildProcess, RunsAFunctionThatMayCrash) {
  const auto file = folder_.path() / "result";
  EXPECT_TRUE(run_in_child([&] {
                std::ofstream(file) << "done";
                return 0;
              }).succeeded());
  EXPECT_EQ(std::filesystem::file_size(file), 4u);
  EXPECT_EQ(run_in_child([] { return 3; }).exit_code, 3);
  const auto crashed = run_in_child([] { return std::raise(SIGKILL); });
  EXPECT_EQ(crashed.signal, SIGKILL);
  EXPECT_FALSE(crashed.timed_out);
}

TEST_F(ChildProcess, TellsWhatAFunctionThrewAndStopsOneThatDoesNotEnd) {
  EXPECT_EQ(run_in_child([]() -> int { throw std::runtime_error("no such luck"); }, {.log = log()}).exit_code, 1);
  EXPECT_EQ(last_lines(log()), "no such luck");
  const auto late = run_in_child(
      [] {
        while (true)
          pause();
        return 0;
      },
      {.wall_limit = 0.1});
  EXPECT_TRUE(late.timed_out);
}

} // namespace
