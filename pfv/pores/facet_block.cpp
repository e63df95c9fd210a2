#include "pfv/pores/facet_block.hpp"

#include "pfv/pores/lens.hpp"
#include "pfv/pores/open_area.hpp"

namespace pfv {
namespace {

using lanes::at, lanes::Vector;

/// Normals, areas and whole sectors; counts the lanes in which spheres overlap and in which a disc reaches across the
/// opposite side.
PFV_VECTORISED void measure_sectors(FacetBlock& block, int& overlapping, int& reaching) {
  int overlaps = 0, reaches = 0;
  for (int t = 0; t < FacetBlock::width; ++t) {
    const Vector a = at(block.corners[0], t), b = at(block.corners[1], t), c = at(block.corners[2], t);
    const double ra = block.corners[0].radius[t], rb = block.corners[1].radius[t], rc = block.corners[2].radius[t];
    const Vector ab = b - a, bc = c - b, ca = a - c;
    const Vector twice = cross(ab, Vector{-ca.x, -ca.y, -ca.z});
    const double double_area = norm(twice);
    const double scale = 1 / (double_area > 0 ? double_area : 1);
    block.normal[0][t] = scale * twice.x;
    block.normal[1][t] = scale * twice.y;
    block.normal[2][t] = scale * twice.z;
    block.area[t] = 0.5 * double_area;
    const double alpha = lanes::atan2(double_area, -dot(ab, ca));
    const double beta = lanes::atan2(double_area, -dot(bc, ab));
    const double gamma = lanes::atan2(double_area, -dot(ca, bc));
    block.sector[0][t] = 0.5 * ra * ra * alpha;
    block.sector[1][t] = 0.5 * rb * rb * beta;
    block.sector[2][t] = 0.5 * rc * rc * gamma;
    const double ab2 = dot(ab, ab), bc2 = dot(bc, bc), ca2 = dot(ca, ca);
    overlaps += (ab2 < (ra + rb) * (ra + rb)) | (bc2 < (rb + rc) * (rb + rc)) | (ca2 < (rc + ra) * (rc + ra));
    const double square = double_area * double_area;
    reaches += (square < ra * ra * bc2) | (square < rb * rb * ca2) | (square < rc * rc * ab2);
  }
  overlapping = overlaps;
  reaching = reaches;
}

/// Parts discs by their radical lines. That is exact where the line of two leaves both discs before it meets those of
/// the third, at `inward` from the side, and no disc reaches across a side.
PFV_VECTORISED void part_overlaps(FacetBlock& block) {
  FacetBlock::Lane overlaps{}, reaches{};
  block.crowding.fill(0);
  for (int c = 0; c < 3; ++c) {
    const auto &one = block.corners[c], &other = block.corners[(c + 1) % 3], &third = block.corners[(c + 2) % 3];
    auto &of_one = block.sector[c], &of_other = block.sector[(c + 1) % 3];
    for (int t = 0; t < FacetBlock::width; ++t) {
      const Vector along = at(other, t) - at(one, t), to_third = at(third, t) - at(one, t);
      const double radius = one.radius[t], apart = norm(along);
      const double distance = lens::radical_distance(apart, radius, other.radius[t]);
      of_one[t] -= lens::half_segment(radius, distance);
      of_other[t] -= lens::half_segment(other.radius[t], apart - distance);
      const double power = (radius - third.radius[t]) * (radius + third.radius[t]) + dot(to_third, to_third);
      const double inward = 0.25 * (power * apart - 2 * distance * dot(to_third, along)) / block.area[t];
      const bool parted = (inward * std::abs(inward) >= (radius - distance) * (radius + distance)) & (distance >= 0) &
                          (distance <= apart);
      const bool overlap = apart < radius + other.radius[t];
      block.crowding[t] += overlap & !parted ? 1 : 0;
      overlaps[t] += overlap ? 1 : 0;
      reaches[t] += 2 * block.area[t] < third.radius[t] * apart ? 1 : 0;
    }
  }
  for (int t = 0; t < FacetBlock::width; ++t)
    block.crowding[t] += overlaps[t] * reaches[t];
}

PFV_VECTORISED void cut_reaches(FacetBlock& block) {
  for (int c = 0; c < 3; ++c) {
    const auto &own = block.corners[c], &next = block.corners[(c + 1) % 3], &last = block.corners[(c + 2) % 3];
    auto& sector = block.sector[c];
    for (int t = 0; t < FacetBlock::width; ++t) {
      const Vector from = at(next, t), side = at(last, t) - from;
      const double length = norm(side);
      const double start = dot(from - at(own, t), side) / length;
      const double distance = 2 * block.area[t] / length;
      sector[t] -= lens::reach_across(own.radius[t], distance, start, start + length);
    }
  }
}

PFV_VECTORISED void measure_fluid(FacetBlock& block) {
  for (int t = 0; t < FacetBlock::width; ++t) {
    const double ra = block.corners[0].radius[t], rb = block.corners[1].radius[t], rc = block.corners[2].radius[t];
    const double larger = ra > rb ? ra : rb;
    block.fluid_area[t] = open_area(block.area[t], block.sector[0][t] + block.sector[1][t] + block.sector[2][t],
                                    larger > rc ? larger : rc);
  }
}

PFV_VECTORISED void measure_smallest_gaps(FacetBlock& block) {
  for (int t = 0; t < FacetBlock::width; ++t) {
    double smallest = 1;
    for (int c = 0; c < 3; ++c) {
      const auto &one = block.corners[c], &other = block.corners[(c + 1) % 3];
      const double apart = norm(at(other, t) - at(one, t));
      const double gap = 1 - (one.radius[t] + other.radius[t]) / (apart > 0 ? apart : 1);
      smallest = gap < smallest ? gap : smallest;
    }
    block.gap[t] = smallest > 0 ? smallest : 0;
  }
}

} // namespace

void FacetBlock::measure_gaps() {
  measure_smallest_gaps(*this);
}

void FacetBlock::measure() {
  int overlaps = 0, reaches = 0;
  measure_sectors(*this, overlaps, reaches);
  overlapping = overlaps > 0;
  if (overlapping)
    part_overlaps(*this);
  if (reaches > 0)
    cut_reaches(*this);
  measure_fluid(*this);
}

} // namespace pfv
