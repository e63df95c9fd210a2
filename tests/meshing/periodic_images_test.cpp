#include "meshing/periodic_images.hpp"

#include "meshing/contact_bridges.hpp"
#include "meshing/matching_points.hpp"
#include "pfv/problem/generate.hpp"

#include <algorithm>
#include <gtest/gtest.h>

namespace {

using meshing::with_images;
using pfv::Lattice;
using pfv::Vec3;

constexpr pfv::PeriodicAxes everywhere{true, true, true};

TEST(PeriodicImages, AreThoseSeenFromTheBox) {
  const auto one = [](const Vec3& centre, const pfv::PeriodicAxes& periodic) {
    return with_images({{}, {{centre, 0.2}}}, periodic).packing.spheres.size();
  };
  EXPECT_EQ(one({0.5, 0.5, 0.5}, everywhere), 1);
  EXPECT_EQ(one({0.1, 0.5, 0.5}, everywhere), 2);
  EXPECT_EQ(one({0.1, 0.9, 0.5}, everywhere), 4);
  EXPECT_EQ(one({0, 0, 0}, everywhere), 8);
  EXPECT_EQ(one({0, 0, 0}, {true, false, false}), 2);
  EXPECT_EQ(one({0, 0, 0}, {}), 1);
  EXPECT_EQ(one({0.24, 0.5, 0.5}, everywhere), 2); // near enough to be touched across the face
}

TEST(PeriodicImages, KnowWhereTheyComeFrom) {
  const auto packing = pfv::lattice_packing(Lattice::fcc, 0.6, 1, 2, everywhere);
  const auto imaged = with_images(packing, everywhere);
  ASSERT_EQ(imaged.original.size(), imaged.packing.spheres.size());
  for (std::size_t k = 0; k < imaged.original.size(); ++k) {
    const Vec3 home = imaged.packing.spheres[k].centre - imaged.shift(k);
    EXPECT_LT((home - packing.spheres.at(imaged.original[k]).centre).norm(), 1e-14);
    EXPECT_EQ(k < packing.spheres.size(), imaged.shift(k).isZero(0));
  }
  // Eight corners and six middles of faces, as in the box between planes of symmetry.
  EXPECT_EQ(imaged.original.size(), pfv::lattice_packing(Lattice::fcc, 0.6, 1, 2).spheres.size());
}

TEST(PeriodicImages, AreBridgedLikeTheSpheresBetweenPlanesOfSymmetry) {
  for (const Lattice kind : {Lattice::simple_cubic, Lattice::bcc, Lattice::fcc}) {
    const double touching = pfv::touching_solid_fraction(kind);
    const auto imaged = with_images(pfv::lattice_packing(kind, touching, 1, 1, everywhere), everywhere);
    EXPECT_EQ(meshing::contact_bridges(imaged.packing, 0.15, everywhere).size(),
              meshing::contact_bridges(pfv::lattice_packing(kind, touching, 1), 0.15).size());
  }
}

TEST(MatchingPoints, AreFoundWithinTheToleranceOnly) {
  const std::vector<Vec3> to{{0, 0, 0}, {1, 2, 3}, {1, 2, 3.1}};
  const std::vector<Vec3> from{{1, 2, 3.1 + 9e-7}, {-9e-7, 9e-7, 0}, {1, 2, 3 + 2e-6}};
  EXPECT_EQ(meshing::matching_points(from, to, 1e-6), (std::vector{2, 0, -1}));
}

} // namespace
