// Boxes that repeat: a channel that is known exactly, and one cell of lattices against the same lattices between their
// planes of symmetry.

#include "pfv/problem/error.hpp"
#include "pfv/problem/generate.hpp"
#include "reference/stokes_fem/box_mesh.hpp"
#include "reference/stokes_fem/flow_on_mesh.hpp"
#include "reference/stokes_fem/stokes_fem.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <unistd.h>

namespace {

using pfv::Axis;
using pfv::Lattice;
using pfv::Vec3;

constexpr double tolerance = 1e-7;

Vec3 sum(const auto& forces) {
  Vec3 total = Vec3::Zero();
  for (const Vec3& force : forces)
    total += force;
  return total;
}

class PeriodicBox : public ::testing::Test {
protected:
  void SetUp() override {
    setenv("PFV_MESH_CACHE", TEST_MESH_CACHE, 1);
    if (const auto reason = method->unavailable())
      GTEST_SKIP() << *reason;
  }

  reference::Answer solve(const pfv::Case& problem, const reference::Request& request) const {
    pfv::Clock clock;
    return method->solve(problem, request, clock);
  }

  std::unique_ptr<reference::Method> method = reference::make_stokes_fem();
};

constexpr pfv::PeriodicAxes everywhere{true, true, true};

pfv::Case lattice(Lattice kind, double solid_fraction, const pfv::PeriodicAxes& periodic,
                  const Vec3& shift = Vec3::Zero()) {
  pfv::Case problem;
  problem.packing = pfv::lattice_packing(kind, solid_fraction, 1, 1, periodic);
  problem.faces = pfv::flow_along(Axis::z, 1, periodic, problem.packing.box);
  for (pfv::Sphere& sphere : problem.packing.spheres)
    for (int axis = 0; axis < 3; ++axis)
      if (periodic[static_cast<std::size_t>(axis)])
        sphere.centre[axis] = std::fmod(sphere.centre[axis] + shift[axis], 1);
  return problem;
}

} // namespace

// Plates at x = 0 and 0.5 that pose as spheres, y and z without end, dp/dz = 6.
TEST(PeriodicChannel, IsExact) {
  pfv::Case problem;
  problem.packing = {{Vec3::Zero(), Vec3(0.5, 0.75, 1)}, {{{0, 0.3, 0.3}, 1e-3}, {{0.5, 0.3, 0.3}, 1e-3}}};
  problem.faces = pfv::flow_along(Axis::z, 6, {false, true, true}, problem.packing.box);
  const auto file = std::filesystem::temp_directory_path() / ("endless_" + std::to_string(getpid()) + ".msh");
  write_box_mesh(file, problem.packing.box, {2, 3, 3}, {"sphere_0", "sphere_1", "y_min", "y_max", "z_min", "z_max"});
  pfv::Clock clock;
  const reference::Probes probes{{{0.1, 0.2, 0.3}, {0.1, -0.55, 2.3}},
                                 {{{0, 0, 0}, {0.5, 0, 0}, {0.5, 0.75, 0}, {0, 0.75, 0}},
                                  {{0, 0.4, 0.7}, {0.5, 0.4, 0.7}, {0.5, 1.15, 1.2}, {0, 1.15, 1.2}}}};
  const auto answer = reference::stokes_fem::flow_on_mesh(problem, file, 0.2, clock, probes);
  std::filesystem::remove(file);

  const double flux = 6 * 0.75 * std::pow(0.5, 3) / 12;
  EXPECT_NEAR(answer.face_flux[4] / flux, 1, tolerance);
  EXPECT_NEAR(answer.face_flux[5] / flux, -1, tolerance);
  EXPECT_NEAR(answer.face_flux[3] / flux, 0, tolerance);
  EXPECT_NEAR(*answer.permeability / (0.25 / 12), 1, tolerance);
  const double drive = 6 * 0.5 * 0.75;
  for (const Vec3& force : *answer.sphere_forces)
    EXPECT_LT((force - Vec3(0, 0, -drive / 2)).norm(), tolerance * drive);
  const auto& pressure = *answer.point_pressures;
  EXPECT_NEAR(pressure[0], 6 * (0.3 - 0.5), tolerance * drive);
  EXPECT_NEAR(pressure[1] - pressure[0], 6 * 2, tolerance * drive);
  for (const double through : *answer.facet_fluxes)
    EXPECT_NEAR(through / -flux, 1, tolerance);
}

namespace {

struct OneCell {
  const char* name;
  Lattice kind;
  double solid_fraction;
  Vec3 shift;

  friend void PrintTo(const OneCell& cell, std::ostream* out) { *out << cell.name; }
};

class PeriodicLattice : public PeriodicBox, public ::testing::WithParamInterface<OneCell> {};

} // namespace

TEST_P(PeriodicLattice, IsTheOneBetweenItsPlanesOfSymmetry) {
  const auto& [name, kind, solid_fraction, shift] = GetParam();
  const pfv::Case problem = lattice(kind, solid_fraction, everywhere, shift);
  const auto answer = solve(problem, {.mesh_size = 1.4});
  const auto mirrored = solve(lattice(kind, solid_fraction, {}), {.mesh_size = 1.4});
  EXPECT_NEAR(*answer.permeability / *mirrored.permeability, 1, 0.01);
  EXPECT_NEAR(*answer.porosity / *mirrored.porosity, 1, 0.002);
  EXPECT_NEAR(answer.face_flux[4] / *answer.permeability, 1, 0.01); // unit box, viscosity and drop
  EXPECT_NEAR(answer.face_flux[4] / -answer.face_flux[5], 1, 1e-9);
  // The drop over the box, exact but for the coarse mesh of bridges' ends, and each sphere the same part of it.
  const auto& forces = *answer.sphere_forces;
  ASSERT_EQ(forces.size(), problem.packing.spheres.size());
  const bool has_bridges = answer.counts.at("bridges") > 0;
  EXPECT_LT((sum(forces) - Vec3(0, 0, -1)).norm(), has_bridges ? 3e-3 : 1e-6);
  for (const Vec3& force : forces)
    EXPECT_LT((force * static_cast<double>(forces.size()) - Vec3(0, 0, -1)).norm(), 0.02);
}

INSTANTIATE_TEST_SUITE_P(Cells, PeriodicLattice,
                         ::testing::Values(OneCell{"sc_343", Lattice::simple_cubic, 0.343, Vec3::Zero()},
                                           OneCell{"sc_343_cut", Lattice::simple_cubic, 0.343, Vec3(0.37, 0.61, 0.55)},
                                           OneCell{"sc_touching", Lattice::simple_cubic,
                                                   pfv::touching_solid_fraction(Lattice::simple_cubic), Vec3::Zero()},
                                           OneCell{"bcc_450_cut", Lattice::bcc, 0.45, Vec3(0.13, 0.27, 0.61)},
                                           OneCell{"bcc_touching", Lattice::bcc,
                                                   pfv::touching_solid_fraction(Lattice::bcc), Vec3::Zero()},
                                           OneCell{"fcc_343", Lattice::fcc, 0.343, Vec3::Zero()}),
                         [](const auto& instance) { return std::string(instance.param.name); });

TEST_F(PeriodicBox, RepeatsAcrossTheFlowOnly) {
  const pfv::Case problem = lattice(Lattice::simple_cubic, 0.343, {true, false, false}, Vec3(0.4, 0, 0));
  const auto answer = solve(problem, {.mesh_size = 1.4});
  const auto mirrored = solve(lattice(Lattice::simple_cubic, 0.343, {}), {.mesh_size = 1.4});
  EXPECT_NEAR(*answer.permeability / *mirrored.permeability, 1, 0.01);
  EXPECT_LT(answer.counts.at("flux_imbalance"), 1e-6);
  EXPECT_LT((sum(*answer.sphere_forces) + sum(*answer.wall_forces)).norm(), 1e-7);
}

TEST_F(PeriodicBox, IsDrivenByAGradientOrNotAtAll) {
  pfv::Case problem = lattice(Lattice::simple_cubic, 0.343, everywhere);
  EXPECT_FALSE(method->not_covered(problem));
  problem.faces.fill(pfv::Periodic{});
  EXPECT_TRUE(method->not_covered(problem));
}
