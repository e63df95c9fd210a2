#include "reference/yade/yade.hpp"

#include "pfv/problem/error.hpp"
#include "pfv/problem/generate.hpp"
#include "reference/pore_volumes/pore_volumes.hpp"
#include "reference/yade/program.hpp"
#include "support/message_of.hpp"
#include "support/temporary_file.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <sstream>
#include <string>

namespace reference {
namespace {

const std::string data = TEST_DATA;

pfv::Case flow_through(const pfv::Packing& packing, pfv::Axis axis = pfv::Axis::y) {
  pfv::Case problem;
  problem.packing = packing;
  problem.faces = pfv::flow_along(axis);
  return problem;
}

pfv::Case flow_through_file(const std::string& name) {
  return flow_through(pfv::read_packing(data + "/" + name + ".txt"));
}

double stored_permeability(const std::string& name) {
  std::ifstream in(data + "/peer_permeability.csv");
  for (std::string line; std::getline(in, line);)
    if (line.starts_with(name + ",")) {
      const auto cells_end = line.find(',', name.size() + 1);
      return std::stod(line.substr(cells_end + 1));
    }
  return std::nan("");
}

std::vector<pfv::Vec3> stored_forces(const std::string& name) {
  std::ifstream in(data + "/" + name + ".peer-forces.txt");
  std::vector<pfv::Vec3> forces;
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with("#"))
      continue;
    std::istringstream words(line);
    std::size_t sphere = 0;
    pfv::Vec3 force;
    words >> sphere >> force.x() >> force.y() >> force.z();
    forces.push_back(force);
  }
  return forces;
}

std::string refusal(const pfv::Case& problem) {
  return make_yade()->not_covered(problem).value_or("");
}

void expect_refused(const pfv::Case& problem, const std::string& words) {
  EXPECT_NE(refusal(problem).find(words), std::string::npos) << refusal(problem);
}

TEST(YadeLimits, TakesThePackingsItWasMeasuredOn) {
  for (const char* name : {"g200", "g2000", "bcc9", "bcc9jit"})
    EXPECT_EQ(refusal(flow_through_file(name)), "") << name;
}

TEST(YadeLimits, RefusesWhatIsNoPermeabilitySetup) {
  auto problem = flow_through_file("g200");
  problem.faces[0] = pfv::Pressure{0.5};
  expect_refused(problem, "two opposite faces");
}

TEST(YadeLimits, RefusesSpheresThatWallsCut) {
  const auto cut = pfv::lattice_packing(pfv::Lattice::bcc, pfv::touching_solid_fraction(pfv::Lattice::bcc), 1);
  expect_refused(flow_through(cut), "sphere 0 reaches out of the box");
}

TEST(YadeLimits, RefusesTwoSpheres) {
  expect_refused(flow_through({{}, {{{0.3, 0.3, 0.3}, 0.2}, {{0.7, 0.7, 0.7}, 0.2}}}), "2 spheres");
}

TEST(YadeLimits, RefusesMoreCellsOnAPressureFaceThanItsArrayHolds) {
  auto problem = flow_through(pfv::lattice_packing(pfv::Lattice::simple_cubic, 0.5, 60));
  EXPECT_EQ(refusal(problem), "");
  problem = flow_through(pfv::lattice_packing(pfv::Lattice::simple_cubic, 0.5, 80));
  expect_refused(problem, "about 10240 cells on a pressure face");
}

class Yade : public ::testing::Test {
protected:
  void SetUp() override {
    if (const auto reason = method_->unavailable())
      GTEST_SKIP() << *reason;
  }
  Answer answer(const pfv::Case& problem) {
    pfv::Clock clock;
    return method_->solve(problem, {}, clock);
  }
  const std::unique_ptr<Method> method_ = make_yade();
};

TEST_F(Yade, NamesItsVersion) {
  EXPECT_TRUE(method_->version().starts_with("YADE 20")) << method_->version();
}

// The stored figures are of the same program with CHOLMOD through Eigen: what differs is round-off.
TEST_F(Yade, GivesTheStoredPermeabilityAndForces) {
  const auto problem = flow_through_file("g200");
  const auto found = answer(problem);
  EXPECT_NEAR(*found.permeability / stored_permeability("g200"), 1, 1e-6);
  EXPECT_NEAR(found.face_flux[2] / *found.permeability, 1, 1e-9); // out at the bottom, unit cube
  EXPECT_NEAR(found.face_flux[3] / found.face_flux[2], -1, 1e-9);
  const auto stored = stored_forces("g200");
  ASSERT_EQ(found.sphere_forces->size(), problem.packing.spheres.size());
  ASSERT_EQ(stored.size(), problem.packing.spheres.size());
  for (std::size_t k = 0; k < stored.size(); ++k)
    EXPECT_NEAR(((*found.sphere_forces)[k] - stored[k]).norm(), 0, 1e-9) << k;
}

// The two differ by what they do at walls: in conductances, and in that it fixes the pressure of all cells there.
TEST_F(Yade, GivesThePressuresOfPoresNearlyAsPoreVolumesDo) {
  auto problem = flow_through_file("g200");
  problem.faces = pfv::flow_along(pfv::Axis::y, -40);
  problem.faces[2] = pfv::Pressure{100};
  problem.faces[3] = pfv::Pressure{60};
  const auto [probes, lines] = pore_probes(problem);
  pfv::Clock clock;
  const auto found = *method_->solve(problem, {.probes = probes}, clock).point_pressures;
  const auto ours = *make_pore_volumes()->solve(problem, {.probes = probes}, clock).point_pressures;
  ASSERT_EQ(found.size(), probes.points.size());
  double squares = 0;
  std::size_t known = 0;
  for (std::size_t i = 0; i < lines; ++i)
    if (std::isfinite(found[i])) {
      squares += std::pow(found[i] - ours[i], 2);
      ++known;
    }
  EXPECT_GT(known, lines / 2);
  EXPECT_LT(std::sqrt(squares / static_cast<double>(known)), 0.05 * 40);
}

TEST_F(Yade, TimesTheFirstIterationAndARepeatedOne) {
  const auto found = answer(flow_through_file("g200"));
  std::vector<std::string> names;
  double first = 0;
  double repeated = 0;
  for (const auto& [name, cpu_seconds] : found.stages) {
    names.push_back(name);
    EXPECT_GE(cpu_seconds, 0) << name;
    (name.starts_with(repeat_prefix) ? repeated : first) += cpu_seconds;
  }
  EXPECT_EQ(names,
            (std::vector<std::string>{"network", "factor", "solve", "forces", "repeat: solve", "repeat: forces"}));
  EXPECT_GT(repeated, 0);
  EXPECT_LT(repeated, first);
  EXPECT_GT(found.counts.at(memory_count), 0);
  EXPECT_LT(found.counts.at(memory_count), found.counts.at("process_memory_bytes"));
}

TEST_F(Yade, AnswersAlongOtherAxesInOtherUnitsAndPlaces) {
  auto problem = flow_through_file("g200");
  const double k = *answer(problem).permeability;
  const pfv::Vec3 shift(3, -2, 1);
  problem.faces = pfv::flow_along(pfv::Axis::z, -2e4);
  problem.fluid.viscosity = 1e-3;
  problem.packing.box = {1e-2 * (problem.packing.box.lower + shift), 1e-2 * (problem.packing.box.upper + shift)};
  for (auto& [centre, radius] : problem.packing.spheres) {
    std::swap(centre.y(), centre.z());
    centre = 1e-2 * (centre + shift);
    radius *= 1e-2;
  }
  const auto found = answer(problem);
  EXPECT_NEAR(*found.permeability / k, 1e-4, 1e-8);
  EXPECT_LT(found.face_flux[4], 0); // from the lower face up
}

TEST_F(Yade, AnExactLatticeIsAFailureWithACause) {
  const auto message = pfv::testing::message_of<pfv::SolveError>([&] { answer(flow_through_file("bcc9")); });
  EXPECT_NE(message.find("not a finite number"), std::string::npos) << message;
}

// What run_script says of a script with this text.
std::string failure_of(const std::string& script, double wall_limit) {
  const pfv::testing::TemporaryFile file("script.py", script);
  return pfv::testing::message_of<pfv::SolveError>(
      [&] { yade::run_script(file.path().parent_path(), "script.py", wall_limit); });
}

TEST_F(Yade, ACrashIsAFailureThatNamesTheSignal) {
  const auto message = failure_of("import os\nos.abort()\n", 300);
  EXPECT_NE(message.find("yade: killed by signal 6 (Aborted)"), std::string::npos) << message;
}

TEST_F(Yade, OneThatDoesNotEndIsStopped) {
  const auto message = failure_of("while True: pass\n", 0.2);
  EXPECT_NE(message.find("yade: stopped after"), std::string::npos) << message;
}

} // namespace
} // namespace reference
