#include "reference/openfoam/patches.hpp"

#include "pfv/problem/error.hpp"

#include <gtest/gtest.h>

namespace reference::openfoam {
namespace {

TEST(Patches, AreNamedAfterWhatTheyArePartOf) {
  EXPECT_EQ(std::get<pfv::Face>(patch_named("y_max")), pfv::Face::y_max);
  EXPECT_EQ(std::get<SphereSurface>(patch_named("sphere_12")).sphere, 12U);
  const auto pair = std::get<PairBridge>(patch_named("bridge_3_15"));
  EXPECT_EQ(pair.first, 3U);
  EXPECT_EQ(pair.second, 15U);
  const auto wall = std::get<WallBridge>(patch_named("bridge_7_z_min"));
  EXPECT_EQ(wall.sphere, 7U);
  EXPECT_EQ(wall.face, pfv::Face::z_min);
}

TEST(Patches, RefuseAnyOtherName) {
  for (const char* name : {"defaultFaces", "sphere_", "sphere_1a", "bridge_1", "bridge_1_", "bridge_x_min_1", "x_mid"})
    EXPECT_THROW(patch_named(name), pfv::SolveError) << name;
}

} // namespace
} // namespace reference::openfoam
