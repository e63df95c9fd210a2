#pragma once

#include "pfv/problem/vec3.hpp"

namespace pfv {

/// Signed solid angle (sr) of the cone spanned by three directions of any length: positive when det(a, b, c) > 0,
/// within
/// (-2 pi, 2 pi). Zero when a direction is zero. Van Oosterom & Strackee 1983, IEEE Trans. Biomed. Eng. 30, 125, eq.
/// (8).
double solid_angle(const Vec3& a, const Vec3& b, const Vec3& c);

} // namespace pfv
