#include "reference/pore_volumes/pore_volumes.hpp"

#include "pfv/problem/generate.hpp"
#include "support/packings.hpp"

#include <cmath>
#include <gtest/gtest.h>

#include <algorithm>

using namespace reference;
using pfv::testing::flow_through;
using pfv::testing::packing_from;

namespace {

Answer answer_of(const Method& method, const pfv::Case& problem) {
  pfv::Clock clock;
  return method.solve(problem, {}, clock);
}

TEST(PoreVolumes, AnswersWhatTheModelSays) {
  const auto problem = flow_through(packing_from("g200.txt"), pfv::Axis::y);
  const auto flow = pfv::testing::solved(problem);
  const Answer answer = answer_of(*make_pore_volumes(), problem);
  EXPECT_DOUBLE_EQ(*answer.permeability, *flow.permeability);
  EXPECT_EQ(answer.unknowns, flow.system.unknowns());
  EXPECT_EQ(answer.face_flux, flow.face_flux);
  ASSERT_EQ(answer.sphere_forces->size(), 200u);
  EXPECT_EQ((*answer.sphere_forces)[7], flow.forces.of_flow(7));
  EXPECT_EQ(answer.counts.at("pores"), 1101);
  const auto repeated = std::ranges::count_if(
      answer.stages, [](const pfv::Stage& stage) { return stage.name.starts_with(repeat_prefix); });
  EXPECT_EQ(answer.stages.size() - static_cast<std::size_t>(repeated), 8u);
  EXPECT_GE(repeated, 5); // geometry, conductances, assemble, solve, forces
}

TEST(PoreVolumes, BothSolversAgree) {
  const auto problem = flow_through(packing_from("bcc9.txt"));
  const auto direct = make_pore_volumes(), relaxed = make_pore_volumes_sor();
  EXPECT_NE(direct->name(), relaxed->name());
  EXPECT_NEAR(*answer_of(*relaxed, problem).permeability / *answer_of(*direct, problem).permeability, 1, 1e-9);
}

TEST(PoreVolumes, AreLooserForLess) {
  const auto problem = flow_through(packing_from("g2000.txt"));
  const auto exact = answer_of(*make_pore_volumes(), problem), loose = answer_of(*make_pore_volumes_loose(), problem);
  EXPECT_LT(loose.counts.at("iterations"), .7 * exact.counts.at("iterations"));
  double difference = 0, whole = 0;
  for (std::size_t k = 0; k < exact.sphere_forces->size(); ++k) {
    difference += ((*loose.sphere_forces)[k] - (*exact.sphere_forces)[k]).squaredNorm();
    whole += (*exact.sphere_forces)[k].squaredNorm();
  }
  EXPECT_GT(difference, 0);
  EXPECT_LT(std::sqrt(difference / whole), 1e-4);
}

TEST(PoreVolumes, CoversOnlyWhatHasAPressure) {
  auto problem = flow_through(packing_from("bcc9.txt"));
  const auto method = make_pore_volumes();
  EXPECT_FALSE(method->not_covered(problem));
  problem.faces = {};
  EXPECT_TRUE(method->not_covered(problem));
}

TEST(PoreVolumes, KnowsItsSizeBeforehand) {
  const auto method = make_pore_volumes();
  for (const char* file : {"g200.txt", "g2000.txt"}) {
    const auto problem = flow_through(packing_from(file));
    EXPECT_NEAR(method->estimate(problem, {}).unknowns / static_cast<double>(answer_of(*method, problem).unknowns), 1,
                0.2);
  }
}

} // namespace
