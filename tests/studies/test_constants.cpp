// The constants of the conductance rule `calibrated` are those that `study calibrate` finds in what the project has
// committed: neither the data, nor the geometry that is fitted, nor the constants can change without the others.
#include "pfv/flow/conductance_rules.hpp"
#include "tests/studies/study_process.hpp"
#include "tests/studies/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <sstream>

namespace {

namespace fs = std::filesystem;

/// The number after a name in what `study calibrate` prints.
double printed(const std::string& text, const std::string& name) {
  std::istringstream lines(text);
  for (std::string word; lines >> word;)
    if (double value = 0; word == name && lines >> value)
      return value;
  ADD_FAILURE() << "no " << name << " in\n" << text;
  return 0;
}

TEST(Calibrated, HasTheConstantsThatTheCommittedDataGive) {
  const TemporaryFolder folder;
  const fs::path committed = fs::path(STUDIES_FOLDER) / "throat_data", copy = folder.path() / "throat_data";
  fs::create_directories(copy / "results");
  fs::copy(committed / "study.toml", copy);
  fs::copy(committed / "packings", copy / "packings");
  for (const char* file : {"permeabilities.csv", "forces.csv"})
    fs::copy(committed / "results" / file, copy / "results");
  const StudyOutput output = study({"calibrate", copy.string()});
  ASSERT_EQ(output.exit_code, 0) << output.err;
  EXPECT_EQ(printed(output.out, "packings"), 71);
  constexpr pfv::Calibrated rule; // a tenth of the standard errors
  EXPECT_NEAR(printed(output.out, "openness"), rule.openness, 0.005);
  EXPECT_NEAR(printed(output.out, "length"), rule.length, 0.002);
  EXPECT_NEAR(printed(output.out, "gap"), rule.gap, 0.004);
  EXPECT_NEAR(printed(output.out, "half_gap"), rule.half_gap, 0.002);
  EXPECT_NEAR(printed(output.out, "contrast"), rule.contrast, 0.01);
  EXPECT_NEAR(printed(output.out, "shear_spread"), rule.shear_spread, 0.002);
}

} // namespace
