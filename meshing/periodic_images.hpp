#pragma once

#include "pfv/problem/packing.hpp"

#include <array>
#include <cstddef>
#include <vector>

namespace meshing {

/// A packing with the images, in boxes around it, of spheres that cut periodic faces of the box or come near them: what
/// is seen of a periodic packing from inside the box.
struct ImagedPacking {
  pfv::Packing packing;                  // the spheres in their order, then images
  std::vector<std::size_t> original;     // of each sphere, itself for the first ones
  std::vector<std::array<int, 3>> boxes; // from the original, along each axis
  pfv::PeriodicAxes periodic{};

  /// What leads from the original to the image (m).
  pfv::Vec3 shift(std::size_t sphere) const;
};

/// Images whose surface is nearer to the box than 0.3 of their radius, so that contacts on its faces have both their
/// spheres. Spheres must be smaller than the box. Without periodic axes nothing is added.
ImagedPacking with_images(const pfv::Packing& packing, const pfv::PeriodicAxes& periodic);

/// All images in the boxes around, for whoever measures distances.
std::vector<pfv::Sphere> all_images(const pfv::Packing& packing, const pfv::PeriodicAxes& periodic);

/// Distance of a point from the box, zero inside (m).
double distance_to_box(const pfv::Box& box, const pfv::Vec3& point);

} // namespace meshing
