// Flow between two parallel plates has a parabolic profile and a linear pressure, both inside the finite element
// spaces: every quantity is exact to the solver's tolerance. The plates pose as spheres, which is what makes a boundary
// no-slip.

#include "pfv/problem/error.hpp"
#include "reference/stokes_fem/box_mesh.hpp"
#include "reference/stokes_fem/flow_on_mesh.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <unistd.h>

namespace {

using pfv::Face;
using pfv::Vec3;

struct Channel {
  double width = 0.5, depth = 0.7,
         length = 1.0; // between the plates (x), between slip walls (y), along the flow (z), m
  double viscosity = 1;
  double inlet = 1, outlet = 0; // Pa, at the top and at the bottom
  std::array<std::string, 6> groups{"sphere_0", "sphere_1", "y_min", "y_max", "z_min", "z_max"};

  pfv::Case problem() const {
    pfv::Case made;
    made.packing.box = {Vec3(3, -2, 1), Vec3(3 + width, -2 + depth, 1 + length)};
    made.packing.spheres.assign(2, {made.packing.box.lower, length});
    made.fluid.viscosity = viscosity;
    made.faces[4] = pfv::Pressure{outlet};
    made.faces[5] = pfv::Pressure{inlet};
    return made;
  }

  reference::Answer solve() const {
    const pfv::Case question = problem();
    const auto file = std::filesystem::temp_directory_path() / ("channel_" + std::to_string(getpid()) + ".msh");
    write_box_mesh(file, question.packing.box, {2, 2, 3}, groups);
    pfv::Clock clock;
    const auto answer = reference::stokes_fem::flow_on_mesh(question, file, 0.2, clock);
    std::filesystem::remove(file);
    return answer;
  }

  double drop() const { return inlet - outlet; }
  double flux() const { return drop() * width * width * width * depth / (12 * viscosity * length); }
};

constexpr double tolerance = 1e-8; // the solver stops at a relative residual of 1e-9

void expect_exact(const Channel& channel) {
  const auto answer = channel.solve();
  const double flux = channel.flux();
  EXPECT_NEAR(answer.face_flux[4] / flux, 1, tolerance);
  EXPECT_NEAR(answer.face_flux[5] / flux, -1, tolerance);
  EXPECT_NEAR(*answer.permeability / (channel.width * channel.width / 12), 1, tolerance);
  EXPECT_NEAR(*answer.porosity, 1, 1e-12);
  const double drive = channel.drop() * channel.width * channel.depth;
  const double push = (channel.inlet + channel.outlet) / 2 * channel.depth * channel.length;
  const double scale = std::abs(drive) + std::abs(push);
  const auto& plates = *answer.sphere_forces;
  EXPECT_LT((plates[0] - Vec3(-push, 0, -drive / 2)).norm(), tolerance * scale);
  EXPECT_LT((plates[1] - Vec3(push, 0, -drive / 2)).norm(), tolerance * scale);
  for (const Vec3& shear : *answer.sphere_viscous_forces)
    EXPECT_LT((shear - Vec3(0, 0, -drive / 2)).norm(), tolerance * scale);
}

} // namespace

TEST(Channel, IsExact) {
  expect_exact({});
}

TEST(Channel, IsExactInAnyUnits) {
  expect_exact({.width = 0.5e-3, .depth = 0.7e-3, .length = 1e-3, .viscosity = 1e-3, .inlet = 2e4, .outlet = 1.9e4});
}

TEST(Channel, FlowsUpwardsWhenTheLowerPressureIsLarger) {
  expect_exact({.inlet = -1, .outlet = 2});
}

TEST(Channel, PushesOnWallsAndOpenFaces) {
  const Channel channel{.inlet = 3, .outlet = 1};
  const auto answer = channel.solve();
  const auto& walls = *answer.wall_forces;
  const double area = channel.width * channel.depth;
  const double push = 2 * channel.width * channel.length;
  EXPECT_LT((walls[2] - Vec3(0, -push, 0)).norm(), tolerance * push);
  EXPECT_LT((walls[3] - Vec3(0, push, 0)).norm(), tolerance * push);
  // No tangential force: the parabola's shear on the inlet is odd about the middle.
  EXPECT_LT((walls[4] - Vec3(0, 0, -1 * area)).norm(), tolerance * push);
  EXPECT_LT((walls[5] - Vec3(0, 0, 3 * area)).norm(), tolerance * push);
}

TEST(Channel, EqualPressuresDriveNothing) {
  const auto answer = Channel{.inlet = 5, .outlet = 5}.solve();
  for (const double flux : answer.face_flux)
    EXPECT_EQ(flux, 0);
  EXPECT_FALSE(answer.permeability);
  Vec3 sum = Vec3::Zero();
  for (const auto& force : *answer.sphere_forces)
    sum += force;
  for (const auto& force : *answer.wall_forces)
    sum += force;
  EXPECT_LT(sum.norm(), 1e-12);
  EXPECT_NEAR((*answer.sphere_forces)[1].x(), 5 * 0.7 * 1.0, 1e-12);
}

TEST(Channel, RefusesAMeshWithStrangeGroups) {
  Channel channel;
  channel.groups[2] = "lid";
  EXPECT_THROW(channel.solve(), pfv::SolveError);
  channel.groups[2] = "sphere_2";
  EXPECT_THROW(channel.solve(), pfv::SolveError);
}

TEST(Channel, RefusesAMeshWithoutTheFaceThatCarriesAPressure) {
  Channel channel;
  channel.groups[5] = "x_max";
  EXPECT_THROW(channel.solve(), pfv::SolveError);
}
