#include "reference/openfoam/convergence.hpp"

#include "pfv/problem/error.hpp"
#include "reference/openfoam/flow_fields.hpp"
#include "reference/temporary_folder.hpp"
#include "support/message_of.hpp"

#include <gtest/gtest.h>

#include <fstream>

namespace reference::openfoam {
namespace {

class FinishedRun : public ::testing::Test {
protected:
  void log(const std::string& text) { std::ofstream(folder_.path() / "log.simpleFoam") << text; }
  void fluxes(const std::string& face, const std::vector<double>& history) {
    const auto where = folder_.path() / "postProcessing" / face / "0";
    std::filesystem::create_directories(where);
    std::ofstream out(where / "surfaceFieldValue.dat");
    out << "# Region type : patch\n# Time sum(phi)\n";
    for (std::size_t i = 0; i < history.size(); ++i)
      out << 10 * (i + 1) << " \t" << history[i] << "\n";
  }
  TemporaryFolder folder_{"convergence-test"};
};

TEST_F(FinishedRun, CountsIterationsAndTheDriftOfTheFlux) {
  log("Time = 20\n\nSIMPLE solution converged in 20 iterations\n\nEnd\n");
  fluxes("x_min", {1, 2});
  fluxes("x_max", {-1, -2});
  const auto found = read_convergence(folder_.path(), {"x_min", "x_max"});
  EXPECT_EQ(found.iterations, 20);
  EXPECT_DOUBLE_EQ(found.flux_drift, 0.5);
}

TEST_F(FinishedRun, AFluxThatStandsStillDoesNotDrift) {
  log("SIMPLE solution converged in 300 iterations\n");
  fluxes("x_min", std::vector<double>(30, 1.5));
  EXPECT_EQ(read_convergence(folder_.path(), {"x_min"}).flux_drift, 0);
}

// simpleFoam exits with 0 and "End" when it runs out of iterations.
TEST_F(FinishedRun, EndIsNotConverged) {
  log("trapFpe: Floating point exception trapping enabled\nTime = 5000\nUx residual 12345\nEnd\n");
  fluxes("x_min", {1, 1});
  const auto message = pfv::testing::message_of<pfv::SolveError>([&] { read_convergence(folder_.path(), {"x_min"}); });
  EXPECT_NE(message.find("did not converge"), std::string::npos) << message;
  EXPECT_NE(message.find("12345"), std::string::npos) << message;
}

TEST(FluxImbalance, IsWhatDoesNotComeOutOverWhatWentIn) {
  EXPECT_NEAR(flux_imbalance({-1, 0.9, 0, 0, 0, 0}), 0.1 / 0.95, 1e-15);
  EXPECT_EQ(flux_imbalance({-1, 0.5, 0.5, 0, 0, 0}), 0);
}

} // namespace
} // namespace reference::openfoam
