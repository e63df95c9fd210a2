#include "pfv/flow/flow_options.hpp"

#include "pfv/flow/choice.hpp"
#include "support/message_of.hpp"
#include "support/temporary_file.hpp"

#include <gtest/gtest.h>

using namespace pfv;
using namespace pfv::testing;

namespace {

FlowOptions read(const std::string& text, const FlowOptionNames& said = {}) {
  const TemporaryFile file("c.toml", text);
  return read_flow_options(file.path(), said);
}

std::string complaint(const std::string& text, const FlowOptionNames& said = {}) {
  const std::string message = message_of<InputError>([&] { read(text, said); });
  return message.substr(message.starts_with('/') ? message.rfind("c.toml") : 0);
}

TEST(FlowOptions, HaveDefaults) {
  const FlowOptions options = read("");
  EXPECT_EQ(name_of(options.walls), "mirror");
  EXPECT_EQ(name_of(options.conductance), "hydraulic-radius");
  EXPECT_TRUE(std::holds_alternative<AutoSolver>(options.solver));
  EXPECT_EQ(name_of(read_flow_options("no-such-packing.txt", {}).walls), "mirror");
}

TEST(FlowOptions, AreReadAndOverridden) {
  const std::string table = "[pfv]\nwalls = \"no-slip\"\nconductance = \"mixed-area\"\nsolver = \"gauss-seidel\"\n";
  const FlowOptions written = read(table);
  EXPECT_EQ(name_of(written.walls), "no-slip");
  EXPECT_EQ(name_of(written.conductance), "mixed-area");
  EXPECT_TRUE(std::holds_alternative<GaussSeidel>(written.solver));
  FlowOptionNames said;
  said.walls = "original";
  EXPECT_EQ(name_of(read(table, said).walls), "original");
  EXPECT_EQ(name_of(read(table, said).conductance), "mixed-area");
}

TEST(FlowOptions, RefuseWhatTheyDoNotKnow) {
  EXPECT_EQ(complaint("[pfv]\nwall = \"mirror\"\n"),
            "c.toml:2: unknown key \"wall\" in [pfv]; valid keys: conductance, walls, solver");
  EXPECT_EQ(complaint("[pfv]\nwalls = \"rough\"\n"),
            "c.toml:2: walls \"rough\" is not one of mirror, no-slip, original");
  EXPECT_EQ(complaint("pfv = 1\n"), "c.toml:1: pfv \"1\" must be a table");
  FlowOptionNames said;
  said.conductance = "kozeny";
  EXPECT_EQ(complaint("", said), "conductance \"kozeny\" is not one of hydraulic-radius, mixed-area, calibrated");
}

} // namespace
