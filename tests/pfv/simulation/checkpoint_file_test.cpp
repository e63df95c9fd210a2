#include "pfv/problem/error.hpp"
#include "pfv/problem/text.hpp"
#include "scenes.hpp"

#include "support/message_of.hpp"
#include "support/temporary_file.hpp"
#include "support/temporary_folder.hpp"

#include <gtest/gtest.h>

using namespace pfv;
using namespace pfv::testing;

namespace {

Checkpoint some() {
  Simulation simulation(drained_box(60, 2, 20));
  for (int n = 0; n < 20; ++n)
    simulation.advance();
  return simulation.checkpoint();
}

/// The line with which a file of this text is refused.
std::string refusal(const std::string& text) {
  const TemporaryFile file("run.checkpoint", text);
  std::string line = message_of<InputError>([&] { read_checkpoint(file.path()); });
  EXPECT_TRUE(line.starts_with(file.path().string() + ": ")) << line;
  EXPECT_EQ(line.find('\n'), std::string::npos) << line;
  return line;
}

void expect_refusal(const std::string& text, const std::string& words) {
  const std::string line = refusal(text);
  EXPECT_NE(line.find(words), std::string::npos) << line;
}

TEST(CheckpointFile, HoldsAllThereIs) {
  const TemporaryFolder folder;
  const Checkpoint checkpoint = some();
  write_checkpoint(folder.path() / "a", checkpoint);
  EXPECT_TRUE(to_bytes(read_checkpoint(folder.path() / "a")) == to_bytes(checkpoint));
}

TEST(CheckpointFile, TakesThePlaceOfTheLastOneWhole) {
  const TemporaryFolder folder;
  const auto file = folder.path() / "a";
  Checkpoint checkpoint = some();
  write_checkpoint(file, checkpoint);
  checkpoint.steps = 77;
  write_checkpoint(file, checkpoint);
  EXPECT_EQ(read_checkpoint(file).steps, 77u);
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 1);
}

TEST(CheckpointFile, ThatCannotBeWrittenLeavesNothing) {
  const TemporaryFolder folder;
  const Checkpoint checkpoint = some();
  const auto says = [&](const std::filesystem::path& file) {
    const std::string line = message_of<InputError>([&] { write_checkpoint(file, checkpoint); });
    EXPECT_NE(line.find('"' + file.string() + "\" cannot be written: "), std::string::npos) << line;
  };
  says(folder.path() / "nowhere" / "a");
  std::filesystem::create_directories(folder.path() / "taken" / "by a folder");
  says(folder.path() / "taken");
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 1);
}

TEST(CheckpointFile, IsRefusedUnlessItIsOne) {
  const TemporaryFolder folder;
  const auto file = folder.path() / "a";
  write_checkpoint(file, some());
  const std::string whole = read_text(file);
  const std::size_t line = whole.find('\n');
  expect_refusal("", "not a checkpoint");
  expect_refusal("# box 0 0 0 1 1 1\n", "not a checkpoint");
  expect_refusal(whole.substr(0, line - 3), "truncated");
  for (const std::size_t size : {line + 1, line + 100, whole.size() - 1})
    expect_refusal(whole.substr(0, size), "truncated");
  expect_refusal(whole + "x", "damaged");
  for (const std::size_t place : {line + 1, (line + whole.size()) / 2, whole.size() - 1}) {
    std::string damaged = whole;
    damaged[place] ^= 4;
    expect_refusal(damaged, "damaged");
  }
  std::string newer = whole;
  newer[std::string("pfv checkpoint ").size()] = '9';
  expect_refusal(newer, "version \"9\"; this pfv reads version 2");
  EXPECT_NE(message_of<InputError>([&] { read_checkpoint(folder.path() / "missing"); }).find("missing"),
            std::string::npos);
}

TEST(CheckpointFile, OfPartsThatDoNotFitIsRefused) {
  Checkpoint checkpoint = some();
  checkpoint.grains.number[0] = 60;
  EXPECT_THROW(from_bytes(to_bytes(checkpoint)), InputError);
  checkpoint.grains.number[0] = 0;
  checkpoint.contacts.pairs.start[3] = 1000;
  EXPECT_THROW(from_bytes(to_bytes(checkpoint)), InputError);
  EXPECT_THROW(from_bytes("\xa1"), InputError);
  EXPECT_THROW(from_bytes("\xa0"), InputError);
}

} // namespace
