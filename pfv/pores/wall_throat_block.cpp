#include "pfv/pores/wall_throat_block.hpp"

#include "pfv/pores/half_angle.hpp"
#include "pfv/pores/lens.hpp"
#include "pfv/pores/open_area.hpp"

namespace pfv {
namespace {

using lanes::at, lanes::Vector;

PFV_INLINE Vector at(const std::array<WallThroatBlock::Lane, 3>& vector, int t) {
  return {vector[0][t], vector[1][t], vector[2][t]};
}

/// The sector of a disc runs from the other sphere to the wall, less what reaches across the way from that sphere to
/// its foot.
PFV_VECTORISED void measure_trapezoids(WallThroatBlock& block) {
  for (int t = 0; t < WallThroatBlock::width; ++t) {
    const double ra = block.corners[0].radius[t], rb = block.corners[1].radius[t];
    const double to_wall_a = block.distance[0][t], to_wall_b = block.distance[1][t];
    const Vector outward = at(block.outward, t);
    const Vector ab = at(block.corners[1], t) - at(block.corners[0], t);
    const Vector turned = cross(ab, outward);
    const double apart = norm(turned), rise = dot(ab, outward); // of the feet; towards the wall
    const double scale = 1 / (apart > 0 ? apart : 1);
    block.normal[0][t] = scale * turned.x;
    block.normal[1][t] = scale * turned.y;
    block.normal[2][t] = scale * turned.z;
    block.area[t] = 0.5 * (to_wall_a + to_wall_b) * apart;
    block.sector[0][t] = 0.5 * ra * ra * lanes::atan2(apart, rise) - lens::reach_across(ra, apart, rise, to_wall_a);
    block.sector[1][t] = 0.5 * rb * rb * lanes::atan2(apart, -rise) - lens::reach_across(rb, apart, -rise, to_wall_b);
    block.fluid_area[t] = open_area(block.area[t], block.sector[0][t] + block.sector[1][t], ra > rb ? ra : rb);
    const bool is_crowded = (dot(ab, ab) < (ra + rb) * (ra + rb)) | (to_wall_a < ra) | (to_wall_b < rb);
    block.crowding[t] = is_crowded ? 1 : 0;
  }
}

PFV_INLINE void add_pyramids(double sign, BipyramidBlock::Side& side, WallThroatBlock& block) {
  for (int t = 0; t < WallThroatBlock::width; ++t) {
    const Vector a = at(block.corners[0], t), b = at(block.corners[1], t), outward = at(block.outward, t);
    const Vector ab = b - a, p = at(side, t);
    const double nab = norm(ab), apart = norm(cross(ab, outward));
    const double height = sign * dot(p - a, at(block.normal, t));
    const double det = apart * height;
    const double ra = block.corners[0].radius[t], rb = block.corners[1].radius[t];
    const double wetted_a = 2 * ra * ra * half_angle(ab, outward, p - a, nab, 1, det);
    const double wetted_b = 2 * rb * rb * half_angle(outward, -1 * ab, p - b, 1, nab, det);
    side.volume[t] = block.area[t] * height / 3;
    side.void_volume[t] = side.volume[t] - (ra * wetted_a + rb * wetted_b) / 3;
    block.length[t] += height;
    block.wetted[0][t] += wetted_a;
    block.wetted[1][t] += wetted_b;
    block.wetted[2][t] += 0.5 * det; // the triangle between the feet and the pore's centre
    block.ball[0][t] += ra * wetted_a / 3;
    block.ball[1][t] += rb * wetted_b / 3;
  }
}

PFV_VECTORISED void measure_both_sides(WallThroatBlock& block) {
  block.length.fill(0);
  for (auto* const lane : {&block.wetted[0], &block.wetted[1], &block.wetted[2], &block.ball[0], &block.ball[1]})
    lane->fill(0);
  add_pyramids(-1, block.behind, block);
  add_pyramids(1, block.ahead, block);
}

} // namespace

void WallThroatBlock::measure_facets() {
  measure_trapezoids(*this);
}

void WallThroatBlock::measure_bipyramids() {
  measure_both_sides(*this);
}

} // namespace pfv
