#include "reference/correlations/correlation_method.hpp"
#include "reference/correlations/drag.hpp"
#include "reference/correlations/sizes.hpp"

#include "pfv/problem/error.hpp"
#include "pfv/problem/generate.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace reference {
namespace {

using pfv::Sphere;

constexpr pfv::PeriodicAxes everywhere{true, true, true};

pfv::Case random_case(double solid_fraction, double radius_ratio = 1, pfv::PeriodicAxes periodic = everywhere) {
  pfv::Case problem;
  problem.packing = pfv::random_packing(
      {.spheres = 8, .solid_fraction = solid_fraction, .radius_ratio = radius_ratio, .periodic = periodic});
  problem.faces = pfv::flow_along(pfv::Axis::z, 1, periodic, problem.packing.box);
  return problem;
}

std::vector<Sphere> of_radii(std::initializer_list<double> radii) {
  std::vector<Sphere> spheres;
  for (const double radius : radii)
    spheres.push_back({pfv::Vec3::Zero(), radius});
  return spheres;
}

const Method& correlation(const std::string& name) {
  static const auto list = make_correlations();
  return **std::ranges::find(list, name, [](const auto& method) { return method->name(); });
}

Answer answer(const std::string& name, const pfv::Case& problem) {
  pfv::Clock clock;
  return correlation(name).solve(problem, {}, clock);
}

// By hand at phi = 1/2, d = 1: k = 0.125 / (36 c / 4).
TEST(Drag, KozenyByHand) {
  EXPECT_NEAR(kozeny_permeability(0.5, 1, 5), 1 / 360.0, 1e-15);
  EXPECT_NEAR(kozeny_permeability(0.5, 1, 25 / 6.0), 1 / 300.0, 1e-15);
  EXPECT_NEAR(kozeny_permeability(0.5, 2e-3, 5), 4e-6 / 360.0, 1e-18);
}

// By hand at phi = 1/4: F = 2.5 / 0.5625 + 0.5625 * 1.75 = 5.428819, K = F / 0.75.
TEST(Drag, BeetstraByHand) {
  EXPECT_NEAR(beetstra_drag(0.25), 7.238426, 1e-6);
}

// By hand at phi = 1/8: 1.72625 / 0.669921875 + 0.24 / 0.586181640625.
TEST(Drag, TennetiByHand) {
  EXPECT_NEAR(tenneti_drag(0.125), 2.576793 + 0.409429, 1e-5);
}

// A sphere alone: 3 pi mu d U.
TEST(Drag, IsStokesOfASphereAlone) {
  EXPECT_NEAR(beetstra_drag(1e-12), 1, 1e-5);
  EXPECT_NEAR(tenneti_drag(1e-12), 1, 1e-4);
  // n 3 pi mu d U = |grad p|, with n = phi / (pi d^3 / 6).
  EXPECT_NEAR(permeability_of_drag(0.01, 2, 1) * 3 * std::numbers::pi * 2 * 0.01 / (std::numbers::pi * 8 / 6), 1,
              1e-14);
}

TEST(Drag, BeetstraIsCarmanKozenyWhenDense) {
  const double dense = permeability_of_drag(0.99, 1, beetstra_drag(0.99));
  EXPECT_NEAR(dense / kozeny_permeability(0.99, 1, 5), 1, 1e-5);
}

TEST(Drag, SimulationsAgreeWithinATenth) {
  for (double phi = 0.1; phi <= 0.5; phi += 0.05)
    EXPECT_NEAR(tenneti_drag(phi) / beetstra_drag(phi), 1, 0.1) << phi;
}

TEST(Sizes, SauterDiameterByHand) {
  const std::vector<Sphere> spheres = of_radii({1, 2, 2});
  EXPECT_NEAR(sauter_diameter(spheres), 2 * 17.0 / 9, 1e-14);
  EXPECT_FALSE(equal_spheres(spheres));
}

// 1 + 0.064 (1 - phi) m4 m2 / m3^2, with radii 1, 2, 2: m2 = 9, m3 = 17, m4 = 33.
TEST(Sizes, FactorOfUnequalSpheresIsMadeOfMoments) {
  const std::vector<Sphere> spheres = of_radii({1, 2, 2});
  EXPECT_NEAR(beetstra_packing_factor(0.4, spheres), 1 + 0.064 * 0.6 * 33 * 9 / 289, 1e-14);
  const std::vector<Sphere> equal = of_radii({0.7, 0.7, 0.7});
  EXPECT_EQ(beetstra_packing_factor(0.4, equal), 1);
  EXPECT_NEAR(beetstra_size_factor(0.4, 1), 1 + 0.064 * 0.6, 1e-15);
}

TEST(Correlations, AnswerPermeabilityAndFluxAndNoForces) {
  const pfv::Case problem = random_case(0.5);
  const double d = 2 * problem.packing.spheres.front().radius;
  for (const auto& method : make_correlations()) {
    const Answer found = answer(method->name(), problem);
    EXPECT_FALSE(found.sphere_forces) << method->name();
    EXPECT_NEAR(*found.porosity, 0.5, 1e-12);
    EXPECT_NEAR(found.counts.at(sauter_diameter_count), d, 1e-14);
    EXPECT_NEAR(found.face_flux[4], *found.permeability, 1e-16); // unit box, viscosity and gradient
    EXPECT_EQ(found.face_flux[4], -found.face_flux[5]);
    EXPECT_EQ(found.notes.count("bulk"), 0U);
  }
  EXPECT_NEAR(*answer("carman_kozeny", problem).permeability, d * d / 360, 1e-15);
  EXPECT_NEAR(*answer("ergun", problem).permeability, d * d / 300, 1e-15);
  EXPECT_NEAR(*answer("wyllie_gregory", problem).permeability, d * d / 345.6, 1e-15);
  EXPECT_NEAR(answer("beetstra", problem).counts.at("drag_coefficient"), beetstra_drag(0.5), 1e-12);
  EXPECT_NEAR(answer("tenneti", problem).counts.at("drag_coefficient"), tenneti_drag(0.5), 1e-12);
}

TEST(Correlations, KnowSizesByTheSauterDiameterAndBeetstraByAFactorToo) {
  const pfv::Case problem = random_case(0.45, 3);
  const auto& spheres = problem.packing.spheres;
  const double d = sauter_diameter(spheres);
  EXPECT_NEAR(*answer("carman_kozeny", problem).permeability, kozeny_permeability(0.45, d, 5), 1e-14);
  EXPECT_NEAR(answer("beetstra", problem).counts.at("drag_coefficient"),
              beetstra_drag(0.45) * beetstra_packing_factor(0.45, spheres), 1e-11);
}

TEST(Correlations, SayOutsideOfWhichRangeACaseIs) {
  const auto reason = correlation("tenneti").not_covered(random_case(0.55));
  ASSERT_TRUE(reason);
  EXPECT_NE(reason->find("0.55 is outside of 0.1 to 0.5"), reason->npos) << *reason;
  EXPECT_TRUE(correlation("wyllie_gregory").not_covered(random_case(0.45)));
  EXPECT_FALSE(correlation("beetstra").not_covered(random_case(0.55)));
  for (const auto& method : make_correlations()) {
    EXPECT_TRUE(method->not_covered(random_case(0.05))) << method->name();
    pfv::Clock clock;
    EXPECT_THROW(method->solve(random_case(0.05), {}, clock), pfv::SolveError);
  }
}

TEST(Correlations, AreAskedForBoxesWithWallsAndSayThatTheseAreNoBulk) {
  EXPECT_EQ(answer("beetstra", random_case(0.3, 1, {})).notes.count("bulk"), 1U);
}

TEST(Correlations, DoNotCoverSpheresCutByWalls) {
  pfv::Case problem = random_case(0.3, 1, {});
  problem.packing.spheres[0].centre.x() = 0;
  const auto reason = correlation("ergun").not_covered(problem);
  ASSERT_TRUE(reason);
  EXPECT_NE(reason->find("cut by a wall"), reason->npos);
}

} // namespace
} // namespace reference
