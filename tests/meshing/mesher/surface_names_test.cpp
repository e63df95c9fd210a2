#include "meshing/mesher/surface_names.hpp"

#include "pfv/problem/generate.hpp"
#include "support/message_of.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <stdexcept>

namespace {

using mesher::name_of_surface;
using pfv::Vec3;

class SurfaceNames : public testing::Test {
protected:
  std::string name(const std::vector<Vec3>& points) const { return name_of_surface(points, packing, bridges); }
  std::string fault(const std::vector<Vec3>& points) const {
    return pfv::testing::message_of<std::runtime_error>([&] { name(points); });
  }

  // One sphere tangent to the six walls: bridges on one line come in twos.
  pfv::Packing packing = pfv::lattice_packing(pfv::Lattice::simple_cubic, 0.52359877559, 1);
  std::vector<meshing::Bridge> bridges = meshing::contact_bridges(packing, 0.2);
};

TEST_F(SurfaceNames, SphereFaceOrBridge) {
  const Vec3 centre(0.5, 0.5, 0.5);
  const double r = packing.spheres[0].radius;
  EXPECT_EQ(name({centre + r * Vec3(1, 2, 3).normalized(), centre - r * Vec3(1, 0, 1).normalized()}), "sphere_0");
  EXPECT_EQ(name({{0.1, 0.2, 1}, {0.3, 0.7, 1}, {0.9, 0.1, 1}}), "z_max");
  const double rim = 0.2 * r;
  EXPECT_EQ(name({{0.001, 0.5 + rim, 0.5}, {0.01, 0.5, 0.5 - rim}}), "bridge_0_x_min");
  EXPECT_EQ(name({{0.999, 0.5 + rim, 0.5}, {0.99, 0.5, 0.5 - rim}}), "bridge_0_x_max");
}

TEST_F(SurfaceNames, NoneIsAnError) {
  EXPECT_NE(fault({{0.1, 0.2, 0.3}}).find("no sphere, bridge or face"), std::string::npos);
  EXPECT_NE(fault({{0.1, 0.2, 1}, {0.1, 0.2, 0.9}}).find("(0.1, 0.2, 1)"), std::string::npos);
}

TEST_F(SurfaceNames, TwoAreAnError) {
  EXPECT_NE(fault({{0.3, 0, 1}, {0.7, 0, 1}}).find("y_min and z_max"), std::string::npos);
}

} // namespace
