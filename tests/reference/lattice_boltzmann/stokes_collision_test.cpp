#include "reference/lattice_boltzmann/lattice_flow/stokes_collision.hpp"

#include <gtest/gtest.h>

namespace reference::lattice_boltzmann {
namespace {

using Populations = std::array<double, directions>;

// Whatever they are, but the same each time.
Populations some() {
  Populations f;
  for (std::size_t d = 0; d < directions; ++d)
    f[d] = 0.01 * static_cast<double>((7 * d + 3) % 19);
  return f;
}

StokesCollision::Vector momentum(const Populations& f) {
  return StokesCollision(1, 1, {}).velocity(f);
}

TEST(Velocities, AreIsotropic) {
  for (std::size_t a = 0; a < 3; ++a)
    for (std::size_t b = 0; b < 3; ++b) {
      double second = 0;
      for (std::size_t d = 0; d < directions; ++d)
        second += weight(d) * steps[d][a] * steps[d][b];
      EXPECT_NEAR(second, a == b ? 1. / 3 : 0, 1e-15);
    }
}

TEST(Velocities, KnowTheirOpposites) {
  for (std::size_t d = 0; d < directions; ++d) {
    const Step& c = steps[d];
    EXPECT_EQ(direction_of({-c[0], -c[1], -c[2]}), opposite(d));
  }
  EXPECT_EQ(direction_of({1, 1, 1}), directions);
}

TEST(StokesCollision, KeepsMassAndAddsTheForceToTheMomentum) {
  const StokesCollision collision(0.3, 3. / 16, {1, -2, 0.5});
  Populations f = some();
  const double mass = StokesCollision::density(f);
  const auto before = momentum(f);
  collision(f);
  EXPECT_NEAR(StokesCollision::density(f), mass, 1e-14);
  for (std::size_t a = 0; a < 3; ++a)
    EXPECT_NEAR(momentum(f)[a] - before[a], collision.force()[a], 1e-14);
}

TEST(StokesCollision, IsLinear) {
  const StokesCollision once(0.3, 3. / 16, {1, 0, 0});
  const StokesCollision thousandfold(0.3, 3. / 16, {1000, 0, 0});
  Populations f = some();
  Populations g = f;
  for (double& population : g)
    population *= 1000;
  once(f);
  thousandfold(g);
  for (std::size_t d = 0; d < directions; ++d)
    EXPECT_NEAR(g[d], 1000 * f[d], 1e-11);
}

TEST(StokesCollision, LeavesFluidAtRestWhereAPressureGradientHoldsTheForce) {
  const StokesCollision collision(0.3, 3. / 16, {1, 0, 0});
  Populations f;
  for (std::size_t d = 0; d < directions; ++d)
    f[d] = collision.at_rest(d);
  EXPECT_NEAR(collision.velocity(f)[0], 0, 1e-15);
  collision(f);
  // What leaves for a neighbour finds there the density that is three times the force higher.
  for (std::size_t d = 0; d < directions; ++d)
    EXPECT_NEAR(f[d], weight(d) * 3 * steps[d][0] + collision.at_rest(d), 1e-15);
}

} // namespace
} // namespace reference::lattice_boltzmann
