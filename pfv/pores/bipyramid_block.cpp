#include "pfv/pores/bipyramid_block.hpp"

#include "pfv/pores/half_angle.hpp"
#include "pfv/pores/lens.hpp"

namespace pfv {
namespace {

using lanes::at, lanes::Vector;

/// The pyramids on one side of the facets, sign 1 ahead and -1 behind; adds what both sides share to the bipyramids.
PFV_INLINE void add_pyramids(const FacetBlock& facets, double sign, BipyramidBlock::Side& side, BipyramidBlock& block) {
  for (int t = 0; t < FacetBlock::width; ++t) {
    const Vector a = at(facets.corners[0], t), b = at(facets.corners[1], t), c = at(facets.corners[2], t);
    const Vector ab = b - a, ac = c - a, bc = c - b, p = at(side, t);
    const double nab = norm(ab), nac = norm(ac), nbc = norm(bc);
    const double height = sign * dot(p - a, Vector{facets.normal[0][t], facets.normal[1][t], facets.normal[2][t]});
    const double det = 2 * facets.area[t] * height;
    const double ra = facets.corners[0].radius[t], rb = facets.corners[1].radius[t], rc = facets.corners[2].radius[t];
    const double wetted_a = 2 * ra * ra * half_angle(ab, ac, p - a, nab, nac, det);
    const double wetted_b = 2 * rb * rb * half_angle(bc, -1 * ab, p - b, nbc, nab, det);
    const double wetted_c = 2 * rc * rc * half_angle(-1 * ac, -1 * bc, p - c, nac, nbc, det);
    side.volume[t] = facets.area[t] * height / 3;
    side.void_volume[t] = side.volume[t] - (ra * wetted_a + rb * wetted_b + rc * wetted_c) / 3;
    block.length[t] += height;
    block.wetted[0][t] += wetted_a;
    block.wetted[1][t] += wetted_b;
    block.wetted[2][t] += wetted_c;
    block.ball[0][t] += ra * wetted_a / 3;
    block.ball[1][t] += rb * wetted_b / 3;
    block.ball[2][t] += rc * wetted_c / 3;
  }
}

PFV_VECTORISED void measure_sectors(const FacetBlock& facets, BipyramidBlock& block) {
  block.length.fill(0);
  for (int c = 0; c < 3; ++c) {
    block.wetted[c].fill(0);
    block.ball[c].fill(0);
  }
  add_pyramids(facets, -1, block.behind, block);
  add_pyramids(facets, 1, block.ahead, block);
}

/// Gives back what two overlapping spheres both claimed about each side of the facets.
PFV_VECTORISED void part_overlaps(const FacetBlock& facets, BipyramidBlock& block) {
  for (int c = 0; c < 3; ++c) {
    const int d = (c + 1) % 3;
    const auto &one = facets.corners[c], &other = facets.corners[d];
#pragma GCC ivdep
    for (int t = 0; t < FacetBlock::width; ++t) {
      const Vector from = at(one, t), along = at(other, t) - from;
      const double apart = norm(along);
      const Vector normal{facets.normal[0][t], facets.normal[1][t], facets.normal[2][t]};
      const Vector inward = (1 / apart) * cross(normal, along);
      const Vector p = at(block.behind, t) - from, q = at(block.ahead, t) - from;
      const double behind = lanes::atan2(-dot(p, normal), dot(p, inward));
      const double ahead = lanes::atan2(dot(q, normal), dot(q, inward));
      const double distance = lens::radical_distance(apart, one.radius[t], other.radius[t]);
      const double h1 = lens::cap_height(one.radius[t], distance);
      const double h2 = lens::cap_height(other.radius[t], apart - distance);
      const double v1 = lens::cap_volume(one.radius[t], h1, 1), v2 = lens::cap_volume(other.radius[t], h2, 1);
      block.behind.void_volume[t] += (v1 + v2) * behind;
      block.ahead.void_volume[t] += (v1 + v2) * ahead;
      block.ball[c][t] -= v1 * (behind + ahead);
      block.ball[d][t] -= v2 * (behind + ahead);
      block.wetted[c][t] -= lens::cap_surface(one.radius[t], h1, behind + ahead);
      block.wetted[d][t] -= lens::cap_surface(other.radius[t], h2, behind + ahead);
    }
  }
}

PFV_VECTORISED void measure_void(BipyramidBlock& block) {
  for (int t = 0; t < FacetBlock::width; ++t)
    block.void_volume[t] = block.behind.void_volume[t] + block.ahead.void_volume[t];
}

PFV_VECTORISED void measure_pore_contrasts(const FacetBlock& facets, BipyramidBlock& block) {
  for (int t = 0; t < FacetBlock::width; ++t) {
    const Vector centre = at(facets.corners[0], t);
    const Vector to_behind = at(block.behind, t) - centre, to_ahead = at(block.ahead, t) - centre;
    const double square = facets.corners[0].radius[t] * facets.corners[0].radius[t];
    const double one = dot(to_behind, to_behind) - square, other = dot(to_ahead, to_ahead) - square;
    const double sum = std::abs(one) + std::abs(other);
    block.contrast[t] = std::abs(one - other) / (sum > 0 ? sum : 1);
  }
}

} // namespace

void BipyramidBlock::measure_contrasts(const FacetBlock& facets) {
  measure_pore_contrasts(facets, *this);
}

void BipyramidBlock::measure(const FacetBlock& facets) {
  measure_sectors(facets, *this);
  if (facets.overlapping)
    part_overlaps(facets, *this);
  measure_void(*this);
}

} // namespace pfv
