#include "reference/probes.hpp"

#include "pfv/pores/throat_planes.hpp"
#include "pfv/problem/generate.hpp"
#include "reference/method.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace reference {
namespace {

using pfv::Vec3;

pfv::Case loose_random(const pfv::PeriodicAxes& periodic) {
  pfv::Case problem;
  problem.packing =
      pfv::random_packing({.spheres = 30, .solid_fraction = 0.4, .radius_ratio = 2, .seed = 4, .periodic = periodic});
  problem.faces = pfv::flow_along(pfv::Axis::y, 1, periodic, problem.packing.box);
  return problem;
}

Vec3 area_vector(const Probes::Facet& facet) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = 1; i + 1 < facet.size(); ++i)
    sum += (facet[i] - facet[0]).cross(facet[i + 1] - facet[0]) / 2;
  return sum;
}

TEST(Probes, FacetsOfEveryPoreCloseUpToItsWalls) {
  const pfv::Case problem = loose_random({});
  pfv::Clock clock;
  const auto network = pfv::build_pore_network(problem.packing, {}, clock);
  const auto probes = pore_probes(problem, network).probes;
  std::vector<Vec3> sum(network.pores.size(), Vec3::Zero());
  for (std::size_t t = 0; t < network.throats.size(); ++t) {
    const auto [i, j] = network.throats.pores[t];
    sum[static_cast<std::size_t>(i)] += area_vector(probes.facets[t]);
    sum[static_cast<std::size_t>(j)] -= area_vector(probes.facets[t]);
  }
  for (const auto& part : network.wall_parts)
    sum[static_cast<std::size_t>(part.pore)] += part.area * outward_normal(part.face);
  for (const Vec3& left : sum)
    EXPECT_LT(left.norm(), 1e-12);
}

TEST(Probes, FacetsStandAsTheirThroats) {
  for (const pfv::PeriodicAxes periodic : {pfv::PeriodicAxes{}, pfv::PeriodicAxes{true, false, true}}) {
    const pfv::Case problem = loose_random(periodic);
    pfv::Clock clock;
    const auto network = pfv::build_pore_network(problem.packing, periodic, clock);
    const auto probes = pore_probes(problem, network).probes;
    pfv::visit_planes(network, [&](std::size_t throat, const pfv::ThroatPlane& plane) {
      EXPECT_LT((area_vector(probes.facets[throat]) - plane.area * plane.normal).norm(), 1e-12);
    });
  }
}

TEST(Probes, LinesRunAlongTheFlow) {
  const pfv::Case problem = loose_random({});
  const auto [probes, lines] = pore_probes(problem);
  ASSERT_EQ(probes.points.size(), lines + 9 * PoreProbes::points_per_line);
  const Vec3 step = probes.points[lines + 1] - probes.points[lines];
  EXPECT_NEAR(step.y(), problem.packing.box.size().y() / PoreProbes::points_per_line, 1e-12);
  EXPECT_EQ(step.x(), 0);
  EXPECT_EQ(step.z(), 0);
}

TEST(Probes, PoreVolumesFillThem) {
  const pfv::Case problem = loose_random({});
  const auto [probes, lines] = pore_probes(problem);
  pfv::Clock clock;
  const Answer answer = find_method("pore_volumes").solve(problem, {.probes = probes}, clock);
  ASSERT_EQ(answer.point_pressures->size(), probes.points.size());
  ASSERT_EQ(answer.facet_fluxes->size(), probes.facets.size());
  std::size_t solid = 0;
  for (std::size_t i = 0; i < probes.points.size(); ++i) {
    const double pressure = (*answer.point_pressures)[i];
    if (std::isnan(pressure)) {
      EXPECT_GE(i, lines);
      ++solid;
      continue;
    }
    EXPECT_GE(pressure, -1e-12);
    EXPECT_LE(pressure, 1 + 1e-12);
  }
  EXPECT_GT(solid, 9 * PoreProbes::points_per_line / 5);
  EXPECT_LT(solid, 9 * PoreProbes::points_per_line / 5 * 3);
  for (const double flux : *answer.facet_fluxes)
    EXPECT_TRUE(std::isfinite(flux));
}

} // namespace
} // namespace reference
