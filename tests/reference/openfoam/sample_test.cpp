#include "reference/openfoam/sample.hpp"

#include "reference/openfoam/case_files.hpp"
#include "reference/openfoam/cubes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace reference::openfoam {
namespace {

// A box of 2 m, pressure 3 Pa at the bottom and 7 Pa on top; p and u_z linear in z and x.
struct Linear {
  Linear() {
    problem.packing.box = {pfv::Vec3::Zero(), pfv::Vec3::Constant(2)};
    problem.faces = pfv::flow_along(pfv::Axis::z);
    problem.faces[4] = pfv::Pressure{3};
    problem.faces[5] = pfv::Pressure{7};
    problem.fluid.viscosity = 0.5;
    for (const pfv::Vec3& centre : mesh.cell_centres) {
      fields.pressure.push_back(centre.z());
      fields.velocity.emplace_back(0, 0, 1 + centre.x());
    }
  }
  pfv::Case problem;
  FoamMesh mesh = cubes(6);
  FlowFields fields;
};

TEST(Sample, IsExactForLinearFields) {
  const Linear linear;
  Probes probes;
  probes.points = {{0.1, 0.2, 0.3}, {1.9, 1.7, 2}, {1, 1, 0}, {2.1, 1, 1}};
  probes.facets = {{{0.5, 0, 1}, {1.5, 0, 1}, {1.5, 1.5, 1}, {0.5, 1.5, 1}},
                   {{0.5, 0, 1}, {0.5, 1.5, 1}, {1.5, 0, 1}}}; // clear of the slip walls across x, where u has no slope
  const Samples samples = sample(linear.mesh, linear.fields, linear.problem, probes);
  EXPECT_NEAR(samples.point_pressures[0], 3 + 4 * 0.15, 1e-12);
  EXPECT_NEAR(samples.point_pressures[1], 7, 1e-12);
  EXPECT_NEAR(samples.point_pressures[2], 3, 1e-12);
  EXPECT_TRUE(std::isnan(samples.point_pressures[3]));
  // Areas and means of 1 + x in units of the box; the triangle looks along -z.
  const double unit = units_of(linear.problem).flux();
  EXPECT_NEAR(samples.facet_fluxes[0] / unit, 0.375 * 1.5, 1e-12);
  EXPECT_NEAR(samples.facet_fluxes[1] / unit, -0.1875 * (1 + 1.25 / 3), 1e-12);
}

// A sphere of radius 0.5 m in the middle of a facet takes its disc out; inside it there is no pressure.
TEST(Sample, LeavesTheSolidOut) {
  Linear linear;
  linear.problem.packing.spheres = {{{1, 1, 1}, 0.5}};
  for (pfv::Vec3& velocity : linear.fields.velocity)
    velocity = pfv::Vec3::UnitZ();
  Probes probes;
  probes.points = {{1, 1, 1.2}, {1, 1, 1.6}};
  probes.facets = {{{0, 0, 1}, {2, 0, 1}, {2, 2, 1}, {0, 2, 1}}, {{0.9, 0.9, 1}, {1.1, 0.9, 1}, {1, 1.1, 1}}};
  const Samples samples = sample(linear.mesh, linear.fields, linear.problem, probes);
  EXPECT_TRUE(std::isnan(samples.point_pressures[0]));
  EXPECT_NEAR(samples.point_pressures[1], 3 + 4 * 0.8, 1e-12);
  // Two triangles of 1024 parts: the rim of the disc is met to about a part.
  EXPECT_NEAR(samples.facet_fluxes[0] / units_of(linear.problem).flux(), 1 - std::numbers::pi / 16, 2e-3);
  EXPECT_TRUE(std::isnan(samples.facet_fluxes[1]));
}

} // namespace
} // namespace reference::openfoam
