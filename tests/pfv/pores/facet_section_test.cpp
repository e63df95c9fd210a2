#include "pfv/pores/facet_section.hpp"

#include "pfv/pores/throat_measures.hpp"

#include <gtest/gtest.h>
#include <numbers>
#include <random>
#include <vector>

using namespace pfv;

namespace {

constexpr double pi = std::numbers::pi;
const Box box{Vec3::Zero(), Vec3::Constant(10)};

std::vector<Sphere> triangle(double radius) { // equilateral, side 1
  const Vec3 at(4, 4, 4);
  return {{at, radius}, {at + Vec3(1, 0, 0), radius}, {at + Vec3(.5, std::sqrt(.75), 0), radius}};
}

double open(const std::vector<Sphere>& spheres, const std::array<Vertex, 3>& vertices = {0, 1, 2}) {
  return measure_plane(box, spheres, vertices).fluid_area;
}

/// Midpoints of a grid over the facet: a triangle, or what is between its spheres and walls.
double counted(const std::vector<Sphere>& spheres, const Vec3& corner, const Vec3& u, const Vec3& v, bool triangular) {
  constexpr int n = 250;
  int outside = 0;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      const Vec3 at = corner + (i + .5) / n * u + (j + .5) / n * v;
      outside += (!triangular || i + j < n) && std::ranges::none_of(spheres, [&](const Sphere& sphere) {
                   return (sphere.centre - at).squaredNorm() < sphere.radius * sphere.radius;
                 });
    }
  return outside * u.cross(v).norm() / (double(n) * n);
}

TEST(FacetSection, OfEqualSpheresEndsWhenTheyGrowOverTheMiddle) {
  const double whole = std::sqrt(3) / 4, circumradius = 1 / std::sqrt(3);
  EXPECT_NEAR(open(triangle(.5)), whole - pi / 8, 1e-15);
  for (const double r : {.52, .55, .577}) { // sectors less segments, no three in one point
    const double half = std::acos(.5 / r), segment = r * r * (half - std::sin(half) * std::cos(half));
    EXPECT_NEAR(open(triangle(r)), whole - pi / 2 * r * r + 3 * segment, 2e-15) << r;
  }
  for (const double r : {circumradius, .58, .6, .75, .999})
    EXPECT_EQ(open(triangle(r)), 0) << r;
}

TEST(FacetSection, ClosesContinuously) { // the hole is as wide as what is missing, its area as that squared
  const double circumradius = 1 / std::sqrt(3);
  double last = 1;
  for (double missing = 1e-2; missing > 1e-6; missing /= 2) {
    const double area = open(triangle(circumradius - missing));
    EXPECT_GT(area, 0);
    EXPECT_LT(area, last);
    EXPECT_LT(area, 6 * missing * missing);
    last = area;
  }
}

TEST(FacetSection, IsTheUnionOfItsDiscsByCounting) {
  std::mt19937_64 random(5);
  const auto uniform = [&](double from, double to) { return std::uniform_real_distribution(from, to)(random); };
  for (int n = 0; n < 40; ++n) { // of all kinds: reaches across a side, three in one point, one centre in another disc
    std::vector<Sphere> spheres;
    for (int c = 0; c < 3; ++c)
      spheres.push_back({Vec3(uniform(4, 5), uniform(4, 5), uniform(4, 5)), uniform(.05, .7)});
    const Vec3 u = spheres[1].centre - spheres[0].centre, v = spheres[2].centre - spheres[0].centre;
    EXPECT_NEAR(open(spheres), counted(spheres, spheres[0].centre, u, v, true), 6e-3 * u.cross(v).norm()) << n;
  }
}

TEST(FacetSection, EndsOnWalls) {
  const Vertex x = wall_vertex(Face::x_min), y = wall_vertex(Face::y_min);
  for (const double r : {.4, .6, .9, 1.2, 1.6}) {
    const std::vector<Sphere> two{{Vec3(1, 5, 5), r}, {Vec3(.7, 6.2, 5), .8 * r}};
    // The trapezoid between both and the wall, and beyond it their mirror images: as a whole by counting.
    double cut = 0;
    constexpr int n = 300;
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) {
        const double share = (i + .5) / n, depth = (1 - .3 * share);
        const Vec3 at((j + .5) / n * depth, 5 + 1.2 * share, 5);
        cut += depth * std::ranges::none_of(two, [&](const Sphere& sphere) {
                 return (sphere.centre - at).squaredNorm() < sphere.radius * sphere.radius;
               });
      }
    EXPECT_NEAR(open(two, {0, 1, x}), cut * 1.2 / (double(n) * n), 1e-3) << r;
    const std::vector<Sphere> one{{Vec3(1, 1.1, 5), r}};
    EXPECT_NEAR(open(one, {0, x, y}), counted(one, Vec3(0, 0, 5), Vec3(1, 0, 0), Vec3(0, 1.1, 0), false), 1e-3) << r;
  }
}

TEST(FacetSection, PartsDiscsByTheirRadicalLine) {
  const auto spheres = triangle(.6); // closed: each has a third
  const auto part = covered_parts(box, spheres, make_facet(box, spheres, {0, 1, 2}));
  for (const double area : part)
    EXPECT_NEAR(area, std::sqrt(3) / 12, 1e-15);
}

} // namespace
