#pragma once

#include "pfv/problem/packing.hpp"

#include <span>

namespace reference {

/// sum d^3 / sum d^2 (m): the diameter of equal spheres with the same surface in the same volume. Needs a sphere.
double sauter_diameter(std::span<const pfv::Sphere> spheres);

/// Whether all radii are one, to a relative 1e-9.
bool equal_spheres(std::span<const pfv::Sphere> spheres);

/// What beetstra_drag is multiplied by for a whole packing: the sum of the forces 3 pi mu d U K f on all spheres, f the
/// beetstra_size_factor, over that on as much solid in equal spheres of the Sauter diameter. As sum d f is made of
/// moments, that is 1 + 0.064 (1 - phi) m4 m2 / m3^2, m_n = sum d^n; 1 for equal spheres, whose formula has no factor.
double beetstra_packing_factor(double solid_fraction, std::span<const pfv::Sphere> spheres);

} // namespace reference
