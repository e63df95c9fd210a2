#include "pfv/problem/packing.hpp"

#include "pfv/problem/error.hpp"
#include "support/message_of.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace pfv {
namespace {

using testing::message_of;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

Packing two_spheres() {
  return {{}, {{Vec3(0.25, 0.5, 0.5), 0.25}, {Vec3(0.75, 0.5, 0.5), 0.25}}};
}

std::string complaint(const Packing& packing) {
  return message_of<InputError>([&] { validate(packing); });
}

TEST(ValidatePacking, AcceptsWhatMethodsCanWorkWith) {
  EXPECT_EQ(complaint(two_spheres()), "no error");
  Packing overlapping = two_spheres();
  overlapping.spheres[0].radius = 0.4;
  EXPECT_EQ(complaint(overlapping), "no error");
  Packing cut = two_spheres();
  cut.spheres[0].centre = Vec3(0, 0, 1); // on a corner: a sphere cut by symmetry planes
  EXPECT_EQ(complaint(cut), "no error");
}

TEST(ValidatePacking, RefusesRadii) {
  for (const auto& [radius, text] : {std::pair{0.0, "0"}, {-0.1, "-0.1"}, {nan, "nan"}, {infinity, "inf"}}) {
    Packing packing = two_spheres();
    packing.spheres[1].radius = radius;
    EXPECT_EQ(complaint(packing), std::string("spheres[1]: radius \"") + text + "\" must be a positive number (m)");
  }
}

TEST(ValidatePacking, RefusesCentres) {
  Packing packing = two_spheres();
  packing.spheres[0].centre.y() = nan;
  EXPECT_EQ(complaint(packing), "spheres[0]: centre \"0.25 nan 0.5\" must be three finite numbers (m)");
  packing.spheres[0].centre.y() = -infinity;
  EXPECT_EQ(complaint(packing), "spheres[0]: centre \"0.25 -inf 0.5\" must be three finite numbers (m)");
  for (const double outside : {-1e-300, std::nextafter(1.0, 2.0)}) {
    packing.spheres[0].centre.y() = outside;
    EXPECT_NE(complaint(packing).find("must lie in the box \"0 0 0 1 1 1\" (m)"), std::string::npos) << outside;
  }
}

TEST(ValidatePacking, RefusesTwoSpheresAtOnePlace) {
  Packing packing = two_spheres();
  packing.spheres.push_back({packing.spheres[0].centre, 0.1});
  EXPECT_EQ(complaint(packing), "spheres[2]: centre \"0.25 0.5 0.5\" must differ from that of every other sphere; "
                                "spheres[0] has it too");
}

TEST(ValidatePacking, TheTwoZerosAreOnePlace) {
  Packing packing = two_spheres();
  packing.spheres[0].centre = Vec3(0.0, 0.5, 0.25);
  packing.spheres[1].centre = Vec3(-0.0, 0.5, 0.25);
  packing.spheres.push_back({Vec3(0.0, 0.4, 0.25), 0.1}); // sorts between them if the zeros are told apart
  EXPECT_NE(complaint(packing), "no error");
}

TEST(ValidatePacking, RefusesAnEmptyPacking) {
  EXPECT_EQ(complaint(Packing{}), "box: packing has \"0\" spheres and needs at least one");
}

TEST(ValidatePacking, RefusesBoxes) {
  for (const Vec3& upper : {Vec3(1, 0, 1), Vec3(1, -1, 1), Vec3(1, nan, 1), Vec3(1, infinity, 1)}) {
    Packing packing = two_spheres();
    packing.box.upper = upper;
    EXPECT_NE(complaint(packing).find("must be six finite numbers, the lower corner below the upper"),
              std::string::npos)
        << upper.transpose();
  }
  Packing packing = two_spheres();
  packing.box.upper = Vec3::Constant(1e200);
  EXPECT_NE(complaint(packing).find("volume that a double can hold"), std::string::npos);
}

TEST(SolidFraction, CountsSpheresWhole) {
  EXPECT_DOUBLE_EQ(solid_fraction(two_spheres()), 2 * std::numbers::pi / 6 / 8);
  Packing in_a_slab = two_spheres();
  in_a_slab.box.lower = Vec3(0, 0, -1);
  EXPECT_DOUBLE_EQ(solid_fraction(in_a_slab), std::numbers::pi / 6 / 8);
}

} // namespace
} // namespace pfv
