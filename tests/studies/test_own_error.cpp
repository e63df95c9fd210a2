#include "studies/runner/own_error.hpp"

#include "studies/runner/files.hpp"
#include "studies/runner/finding.hpp"
#include "tests/studies/example_row.hpp"
#include "tests/studies/temporary_folder.hpp"

#include <gtest/gtest.h>

namespace {

using reference::Answer;

Answer with(std::map<std::string, double> counts) {
  Answer answer;
  answer.counts = std::move(counts);
  return answer;
}

TEST(OwnError, NoiseIsAShareOfTheFluxThatGetsLost) {
  EXPECT_DOUBLE_EQ(studies::noise(with({{"flux_imbalance", 0.004}})), 0.003);
  EXPECT_EQ(studies::noise(with({})), 0);
}

TEST(OwnError, BridgesCostAShareOfTheFluidTheyTake) {
  EXPECT_DOUBLE_EQ(studies::bridge_error(with({{"bridges", 36}, {"volume_error", -0.003}})), 0.35 * 0.003);
}

TEST(OwnError, OnlyPackingsWithBridgesPayForThem) {
  EXPECT_EQ(studies::bridge_error(with({{"bridges", 0}, {"volume_error", -0.003}})), 0);
  EXPECT_EQ(studies::bridge_error(with({{"volume_error", -0.003}})), 0);
  EXPECT_EQ(studies::bridge_error(with({{"bridges", 6}, {"volume_error", 0.001}})), 0); // a mesh of chords, too coarse
}

// Bridges of 0.15 of the radius: what they take and what they cost, of bridge_calibration.csv.
TEST(OwnError, HoldsWhatBridgesCost) {
  struct {
    const char* packing;
    double taken, cost;
  } const measured[]{{"simple cubic, touching", 0.000628, 0.000023},
                     {"bcc, touching", 0.00162, 0.00010},
                     {"fcc, touching", 0.00327, 0.00047},
                     {"fcc, gaps of 0.019", 0.00788, 0.0026},
                     {"15 random spheres", 0.00046, 0.00011}};
  for (const auto& [packing, taken, cost] : measured)
    EXPECT_GE(studies::bridge_error(with({{"bridges", 1}, {"volume_error", -taken}})), cost) << packing;
}

// k = 1 + 0.05 h^2 at h = 1.4 and 1, with what the answers count.
studies::Finding found(const std::string& method, std::map<std::string, double> counts) {
  const TemporaryFolder folder;
  std::vector<studies::Row> rows;
  for (const double h : {1.4, 1.0}) {
    rows.push_back(example_row(method, h));
    rows.back().permeability = 1 + 0.05 * h * h;
    studies::write_file(studies::answer_file(folder.path(), rows.back().key), reference::to_json(with(counts)));
  }
  return studies::find(rows, folder.path());
}

TEST(OwnError, IsAddedToTheBarOfTheExtrapolation) {
  const auto smooth = found("smooth", {});
  EXPECT_EQ(smooth.bridge_error, 0);
  EXPECT_NEAR(*smooth.permeability->error, 1.25 * 0.05, 1e-12);
  const auto bridged = found("bridged", {{"bridges", 8}, {"volume_error", -0.01}});
  EXPECT_NEAR(bridged.bridge_error, 0.0035, 1e-12);
  EXPECT_NEAR(*bridged.permeability->error, 1.25 * 0.05 + 0.0035, 1e-12);
  const auto noisy = found("noisy", {{"flux_imbalance", 0.02}});
  const double worst = 0.015 * (1.96 * 1.05 + 1.098) / 0.96;
  EXPECT_NEAR(*noisy.permeability->error, 1.25 * 0.05 + worst, 1e-12);
}

} // namespace
