#include "pfv/problem/case.hpp"
#include "pfv/problem/error.hpp"
#include "pfv/problem/generate.hpp"
#include "support/message_of.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace pfv {
namespace {

using testing::message_of;

constexpr PeriodicAxes everywhere{true, true, true};

Case with(Face face, const FaceCondition& condition) {
  Case problem{"nine", nine_spheres(), {}, flow_along(Axis::z), std::nullopt};
  problem.faces[index(face)] = condition;
  return problem;
}

Case periodic_cube(double gradient_z) {
  Case problem{"sc", lattice_packing(Lattice::simple_cubic, 0.5, 2, 1, everywhere), {}, {}, std::nullopt};
  problem.faces = flow_along(Axis::z, 2 * gradient_z, everywhere, problem.packing.box);
  return problem;
}

std::string complaint(const Case& problem) {
  return message_of<InputError>([&] { validate(problem); });
}

TEST(AxisNamed, KnowsThree) {
  EXPECT_EQ(axis_named("y"), Axis::y);
  EXPECT_EQ(message_of<InputError>([] { axis_named("w"); }), "axis \"w\" must be one of x, y, z");
}

TEST(PressureProfile, IsLinearBetweenItsPointsAndConstantBeyond) {
  const PressureProfile profile{Axis::x, {{0, 1}, {2, 5}, {3, -1}}};
  EXPECT_EQ(profile.at(-1), 1);
  EXPECT_EQ(profile.at(0), 1);
  EXPECT_EQ(profile.at(0.5), 2);
  EXPECT_EQ(profile.at(2), 5);
  EXPECT_EQ(profile.at(2.5), 2);
  EXPECT_EQ(profile.at(3), -1);
  EXPECT_EQ(profile.at(4), -1);
  EXPECT_EQ((PressureProfile{Axis::x, {{1, 7}}}).at(0), 7);
}

TEST(FlowAlongPeriodicAxes, HasTheGradientOfTheDropAndNoWalls) {
  const Box box{Vec3::Zero(), Vec3(1, 2, 4)};
  const FaceConditions driven = flow_along(Axis::z, 8, everywhere, box);
  EXPECT_EQ(driven[index(Face::z_min)], FaceCondition{Periodic{2}});
  EXPECT_EQ(driven[index(Face::z_max)], FaceCondition{Periodic{2}});
  EXPECT_EQ(driven[index(Face::x_min)], FaceCondition{Periodic{0}});
  EXPECT_EQ(imposed_gradient(driven), Vec3(0, 0, 2));
  EXPECT_EQ(periodic_axes(driven), everywhere);
  const FaceConditions between = flow_along(Axis::z, 8, {true, false, false}, box);
  EXPECT_EQ(between[index(Face::z_max)], FaceCondition{Pressure{8}});
  EXPECT_EQ(between[index(Face::y_max)], FaceCondition{SlipWall{}});
  EXPECT_EQ(periodic_axes(between), (PeriodicAxes{true, false, false}));
}

TEST(PermeabilitySetup, TakesAMeanGradientForItsDrop) {
  const auto setup = permeability_setup(periodic_cube(-3));
  ASSERT_TRUE(setup);
  EXPECT_EQ(setup->axis, Axis::z);
  EXPECT_EQ(setup->pressure_drop, -6);
  EXPECT_EQ(setup->length, 2);
  EXPECT_EQ(setup->area, 4);
  Case problem = periodic_cube(-3);
  problem.pressure_points = {{Vec3(1, 1, 1), 0}};
  EXPECT_TRUE(permeability_setup(problem)) << "one point sets the level";
  problem.pressure_points.push_back({Vec3(0.5, 1, 1), 1});
  EXPECT_FALSE(permeability_setup(problem)) << "two points drive";
}

TEST(PermeabilitySetup, LeavesTheDropOfAFluxToTheAnswer) {
  const auto setup = permeability_setup(with(Face::z_max, Flux{2}));
  ASSERT_TRUE(setup);
  EXPECT_FALSE(setup->pressure_drop);
  EXPECT_FALSE(permeability_setup(with(Face::z_max, Flux{0})));
  EXPECT_FALSE(permeability_setup(with(Face::x_max, Flux{1}))) << "a third face";
  EXPECT_FALSE(permeability_setup(with(Face::z_max, PressureProfile{Axis::x, {{0, 1}}})));
  Case problem = with(Face::z_max, Pressure{1});
  problem.pressure_points = {{Vec3(0.5, 0.5, 0.5), 0}};
  EXPECT_FALSE(permeability_setup(problem)) << "a source inside";
}

TEST(ValidateFaces, RefusesValuesThatAreNotFinite) {
  EXPECT_EQ(complaint(with(Face::z_max, Flux{std::nan("")})), "z_max flux \"nan\" must be a finite number (m^3/s)");
  EXPECT_EQ(complaint(with(Face::z_max, PressureProfile{Axis::x, {{0, INFINITY}}})),
            "z_max pressure \"inf\" must be a finite number (Pa)");
  EXPECT_EQ(complaint(periodic_cube(INFINITY)), "z_min gradient \"inf\" must be a finite number (Pa/m)");
}

TEST(ValidateFaces, RefusesProfilesThatAreNoFunctionOfThePlace) {
  EXPECT_EQ(complaint(with(Face::z_max, PressureProfile{Axis::z, {{0, 1}}})),
            "z_max pressure along \"z\" must be along an axis of the face, not the one across it");
  EXPECT_EQ(complaint(with(Face::z_max, PressureProfile{Axis::x, {}})),
            "z_max pressure \"[]\" must be a number or at least one [position, pressure]");
  EXPECT_EQ(complaint(with(Face::z_max, PressureProfile{Axis::x, {{0, 1}, {1, 2}, {1, 3}}})),
            "z_max position \"1\" must be beyond the one before it, 1 (m)");
}

TEST(ValidateFaces, RefusesHalfAPeriodicAxis) {
  EXPECT_EQ(complaint(with(Face::x_min, Periodic{})),
            "x_min \"periodic 0\" and x_max \"slip\" must both be periodic with the same gradient (Pa/m)");
  Case problem = periodic_cube(1);
  problem.faces[index(Face::z_max)] = Periodic{2};
  EXPECT_EQ(complaint(problem),
            "z_min \"periodic 1\" and z_max \"periodic 2\" must both be periodic with the same gradient (Pa/m)");
}

TEST(ValidateFaces, RefusesOpenFacesThatCannotRepeat) {
  Case problem = with(Face::x_min, Periodic{1});
  problem.faces[index(Face::x_max)] = Periodic{1};
  EXPECT_EQ(complaint(problem), "z_min \"pressure 0\" must be \"slip\" or periodic beside the gradient \"1\" along x");
  problem.faces[index(Face::x_min)] = problem.faces[index(Face::x_max)] = Periodic{};
  EXPECT_EQ(complaint(problem), "no error");
  problem.faces[index(Face::z_max)] = PressureProfile{Axis::x, {{0, 1}}};
  EXPECT_EQ(complaint(problem), "z_max pressure along \"x\" must be along an axis that is not periodic");
}

TEST(ValidateFaces, WantsALevelOfThePressure) {
  Case problem = with(Face::z_min, SlipWall{});
  problem.faces[index(Face::z_max)] = Flux{1};
  const std::string lost =
      "faces \"slip\", \"slip\", \"slip\", \"slip\", \"slip\", \"flux 1\" leave the pressure without "
      "a level; at least one face or point must have a pressure, or a periodic axis a gradient";
  EXPECT_EQ(complaint(problem), lost);
  problem.pressure_points = {{Vec3(0.5, 0.5, 0.5), 0}};
  EXPECT_EQ(complaint(problem), "no error");
  EXPECT_EQ(complaint(periodic_cube(1)), "no error");
  EXPECT_TRUE(complaint(periodic_cube(0)).ends_with("or a periodic axis a gradient"));
}

TEST(ValidatePressurePoints, RefusesPlacesOutsideAndValuesThatAreNotFinite) {
  Case problem = with(Face::z_max, Pressure{1});
  problem.pressure_points = {{Vec3(0.5, 0.5, 1.5), 0}};
  EXPECT_EQ(complaint(problem), "position \"0.5 0.5 1.5\" of a pressure point must lie in the box \"0 0 0 1 1 1\" (m)");
  problem.pressure_points = {{Vec3(0.5, 0.5, 1), std::nan("")}};
  EXPECT_EQ(complaint(problem), "pressure \"nan\" of a pressure point must be a finite number (Pa)");
}

TEST(ValidatePeriodicPacking, RefusesImagesOfOneSphere) {
  Case problem = periodic_cube(1);
  problem.packing = lattice_packing(Lattice::bcc, 0.5, 1);
  EXPECT_EQ(complaint(problem), "spheres[1]: centre \"1 0 0\" must differ from that of every other sphere; spheres[0] "
                                "has its periodic image 0 0 0");
  problem.packing = lattice_packing(Lattice::bcc, 0.5, 1, 1, everywhere);
  EXPECT_EQ(complaint(problem), "no error");
  problem.packing.spheres[0].centre.x() = -0.1;
  EXPECT_TRUE(complaint(problem).starts_with("spheres[0]: centre \"-0.1 0 0\" must lie in the box"));
}

TEST(Digest, ChangesWithEveryConditionAndPoint) {
  std::vector<Case> cases{with(Face::z_max, Pressure{1}),
                          with(Face::z_max, Flux{1}),
                          with(Face::z_max, Flux{2}),
                          with(Face::z_max, Periodic{1}),
                          with(Face::z_max, Periodic{2}),
                          with(Face::z_max, PressureProfile{Axis::x, {{0, 1}}}),
                          with(Face::z_max, PressureProfile{Axis::y, {{0, 1}}}),
                          with(Face::z_max, PressureProfile{Axis::y, {{0, 1}, {1, 1}}}),
                          with(Face::z_max, Pressure{1}),
                          with(Face::z_max, Pressure{1})};
  cases[8].pressure_points = {{Vec3(0.5, 0.5, 0.5), 1}};
  cases[9].pressure_points = {{Vec3(0.5, 0.5, 0.5), 2}};
  std::set<std::string> digests;
  for (const Case& problem : cases)
    digests.insert(digest(problem));
  EXPECT_EQ(digests.size(), cases.size());
}

} // namespace
} // namespace pfv
