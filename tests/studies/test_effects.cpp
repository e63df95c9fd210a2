#include "pfv/problem/error.hpp"
#include "pfv/problem/text.hpp"
#include "studies/effect_cost/effect_report.hpp"
#include "studies/effect_cost/step_cost.hpp"
#include "studies/runner/row_store.hpp"
#include "tests/studies/example_row.hpp"
#include "tests/studies/study_process.hpp"
#include "tests/studies/temporary_folder.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <set>

namespace {

using studies::Row;
using studies::Status;

const std::string text = R"(title = "Effects"
question = "What do they cost?"
[plan]
preparation_steps = 20
warm_up = 2
steps = 10
repeats = 2
[quick]
spheres = 20
steps = 5
[preparation]
packing = { generator = "random", spheres = 30, solid_fraction = 0.3 }
[scene]
contact = { young = 1e6 }
run = { step = 1e-4 }
[[effect]]
id = "contacts"
[[effect]]
id = "gravity"
label = "weight"
beside = "contacts"
steps = 7
adds = { gravity = { acceleration = [0, 0, -9.81] } }
[[effect]]
id = "fluid"
beside = "gravity"
adds = { faces = { z_max = { pressure = 0 } }, fluid = { viscosity = 1 } }
)";

class Effects : public ::testing::Test {
protected:
  StudyOutput run(std::vector<std::string> arguments = {}, const std::string& command = "run") {
    arguments.insert(arguments.begin(), {command, folder_.path().string()});
    return study(arguments);
  }
  studies::EffectStudy read(const std::string& study_text, bool quick = false) {
    return studies::read_effect_study(folder_.write("study.toml", study_text), quick);
  }
  std::vector<Row> rows() const { return studies::read_rows(folder_.path() / "work" / "rows.csv"); }

  TemporaryFolder folder_;
};

std::string with(const std::string& what, const std::string& by) {
  std::string changed = text;
  return changed.replace(changed.find(what), what.size(), by);
}

TEST_F(Effects, NameOneMoreThanTheSceneTheyAreBeside) {
  const auto study = read(text);
  ASSERT_EQ(study.effects.size(), 3U);
  EXPECT_EQ(study.effects[0].scene.find("gravity"), std::string::npos);
  EXPECT_NE(study.effects[1].scene.find("gravity"), std::string::npos);
  EXPECT_EQ(study.effects[1].scene.find("faces"), std::string::npos);
  for (const char* part : {"young", "gravity", "faces", "viscosity"})
    EXPECT_NE(study.effects[2].scene.find(part), std::string::npos) << part;
  EXPECT_EQ(study.effects[1].label, "weight");
  EXPECT_EQ(study.effects[1].steps, 7U);
  EXPECT_EQ(study.effects[2].steps, 10U);
  EXPECT_EQ(read(text, true).effects[1].steps, 5U);
  EXPECT_NE(read(text, true).preparation.find("20"), std::string::npos);
}

TEST_F(Effects, AreRefusedInOneLineThatNamesWhatIsValid) {
  const auto refused = [&](const std::string& what, const std::string& by, const std::string& part) {
    try {
      read(with(what, by));
      ADD_FAILURE() << by << " was taken";
    } catch (const pfv::InputError& error) {
      EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
    }
  };
  refused("beside = \"contacts\"", "beside = \"fluid\"", "beside \"fluid\" must be the id of an effect above");
  refused("id = \"gravity\"", "id = \"contacts\"", "id \"contacts\" appears twice");
  refused("id = \"gravity\"", "id = \"g/1\"", "letters, digits");
  refused("repeats = 2", "repeats = 0", "repeats \"0\" must be a whole number, 1 or more");
  refused("repeats = 2", "repeat = 2", "repeats");
  refused("label", "lable", "label");
}

TEST_F(Effects, AreMeasuredInTurnsStoredAndNotMeasuredAgain) {
  folder_.write("study.toml", text);
  const StudyOutput output = run();
  EXPECT_EQ(output.exit_code, 0) << output.err;
  const auto before = rows();
  ASSERT_EQ(before.size(), 6U);
  EXPECT_EQ(before[0].case_id, "contacts");
  EXPECT_EQ(before[3].case_id, "contacts"); // of the second turn
  for (const Row& row : before) {
    EXPECT_EQ(row.status, Status::answered) << row.message;
    EXPECT_EQ(row.spheres, 30U);
    EXPECT_EQ(row.unknowns > 0, row.case_id == "fluid");
    ASSERT_FALSE(row.stages.empty());
    EXPECT_EQ(row.stages[0].name, "all");
    EXPECT_GT(row.stages[0].cpu_seconds, 0);
    EXPECT_FALSE(row.commit.empty() || row.compiler.empty() || row.flags.empty() || row.machine.empty());
  }
  for (const char* part : {"effect", "weight", "Report: "})
    EXPECT_NE(output.out.find(part), std::string::npos) << output.out;
  EXPECT_EQ(run().exit_code, 0);
  EXPECT_EQ(rows(), before);
  EXPECT_EQ(run({"--quick"}).exit_code, 0); // other grains, so other rows
  EXPECT_EQ(rows().size(), 12U);

  const auto json = nlohmann::json::parse(run({"--json"}, "report").out);
  ASSERT_EQ(json["effects"].size(), 3U);
  EXPECT_FALSE(json["effects"][0].contains("extra_cpu_seconds"));
  EXPECT_TRUE(json["effects"][1].contains("extra_cpu_seconds"));
  EXPECT_EQ(run({"--publish"}, "report").exit_code, 0);
  EXPECT_EQ(studies::read_rows(folder_.path() / "results" / "rows.csv").size(), 6U);
}

TEST_F(Effects, ThatCannotBeRunFailWithTheirCause) {
  folder_.write("study.toml", with("run = { step = 1e-4 }", "run = { step = 1e4 }"));
  const StudyOutput output = run();
  EXPECT_EQ(output.exit_code, 1) << output.err;
  EXPECT_NE(output.out.find("failed"), std::string::npos) << output.out;
  folder_.write("study.toml", with("acceleration", "accelerate"));
  const StudyOutput refused = run();
  EXPECT_EQ(refused.exit_code, 2) << refused.err;
  EXPECT_NE(refused.err.find("acceleration"), std::string::npos) << refused.err;
}

TEST_F(Effects, CostTheMedianOfDifferencesWithinATurn) {
  const auto study = read(text);
  std::vector<Row> rows;
  const auto add = [&](const std::string& id, int repeat, double cpu_seconds) {
    Row row = example_row("pfv run");
    row.case_id = id;
    row.repeats = repeat;
    row.stages = {{"all", cpu_seconds}, {"contacts", 0.5 * cpu_seconds}};
    rows.push_back(row);
  };
  for (const auto& [repeat, slow] : {std::pair{1, 1.0}, {2, 3.0}, {3, 1.1}}) { // the second turn was slow
    add("contacts", repeat, slow * 10e-6);
    add("gravity", repeat, slow * 12e-6);
    add("fluid", repeat, slow * 12e-6 + (repeat - 2) * 1e-6);
  }
  const auto costs = studies::effect_costs(study, rows);
  ASSERT_EQ(costs.size(), 3U);
  EXPECT_FALSE(costs[0].extra);
  EXPECT_NEAR(costs[0].all->median, 11e-6, 1e-12);
  EXPECT_NEAR(costs[1].extra->median, 2.2e-6, 1e-12);
  EXPECT_NEAR(costs[1].extra->most, 6e-6, 1e-12);
  EXPECT_TRUE(costs[1].is_resolved());
  EXPECT_FALSE(costs[2].is_resolved());
  const auto table = studies::effect_table(study, costs);
  EXPECT_EQ(table.rows[1][4], "2.2");
  EXPECT_EQ(table.rows[2][4], "unresolved");
  EXPECT_EQ(studies::effect_stages(study, rows).rows[0], (std::vector<std::string>{"contacts", "5.5"}));
}

TEST(StepCost, SurvivesItsFile) {
  const studies::StepCost cost{20, 30, 4000, {{"all", 1.25e-5}, {"contacts", 1e-5}}};
  EXPECT_EQ(studies::step_cost_from_json(studies::to_json(cost)), cost);
}

TEST(EffectsStudy, RunsQuicklyAndPaysOnlyForWhatIsNamed) {
  const TemporaryFolder work;
  const StudyOutput output = study({"run", "effects", "--quick", "--work", work.path().string()});
  EXPECT_EQ(output.exit_code, 0) << output.err;
  const auto rows = studies::read_rows(work.path() / "rows.csv");
  std::set<std::string> effects;
  for (const Row& row : rows) {
    effects.insert(row.case_id);
    std::set<std::string> stages;
    for (const pfv::Stage& stage : row.stages)
      stages.insert(stage.name);
    const bool lubricated = row.case_id.starts_with("lubric") || row.case_id == "squeeze";
    EXPECT_EQ(stages.contains("lubrication"), lubricated) << row.case_id;
    EXPECT_EQ(stages.contains("solve"), row.unknowns > 0) << row.case_id;
    if (row.unknowns == 0) {
      EXPECT_EQ(stages.size(), lubricated ? 4U : 3U) << row.case_id; // all, contacts, motion
    }
  }
  for (const char* id : {"contacts", "gravity", "buoyancy", "cohesion", "fluid", "compressible", "lubrication"})
    EXPECT_TRUE(effects.contains(id)) << id;
}

} // namespace
