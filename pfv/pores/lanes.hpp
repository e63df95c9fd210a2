#pragma once

#include <cmath>
#include <numbers>

/// A function whose loops over lanes are compiled for several instruction sets, the best one chosen when the program
/// starts. Such loops hold nothing but arithmetic and selections, so that the compiler turns them into vector
/// instructions.
#if defined(__x86_64__) && defined(__gnu_linux__) && !defined(__SANITIZE_ADDRESS__)
#define PFV_VECTORISED __attribute__((target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default")))
#else
#define PFV_VECTORISED
#endif
#define PFV_INLINE __attribute__((always_inline)) inline

namespace pfv::lanes {

/// Angle of (x, y) in (-pi, pi] as std::atan2 gives it, to 4e-16 of pi, 0 for (0, 0): without branches. The arc tangent
/// below tan(pi/8) is a Chebyshev fit, between it and 1 that of the angle to the diagonal.
PFV_INLINE double atan2(double y, double x) {
  const double across = std::abs(y), along = std::abs(x);
  const double high = across > along ? across : along, low = across > along ? along : across;
  const bool near_diagonal = low > 0.41421356237309503 * high;
  const double over = near_diagonal ? low - high : low;
  const double under = near_diagonal ? low + high : high;
  const double t = over / (under == 0 ? 1 : under);
  const double z = t * t;
  double p = -0.01917688711906226;
  p = p * z + 0.03923165829558719;
  p = p * z - 0.0508544973794026;
  p = p * z + 0.0585814891280221;
  p = p * z - 0.06664511447381948;
  p = p * z + 0.07692183190826087;
  p = p * z - 0.09090904578123903;
  p = p * z + 0.11111111015256361;
  p = p * z - 0.14285714284666542;
  p = p * z + 0.1999999999999552;
  p = p * z - 0.3333333333333333;
  double angle = t + t * z * p;
  angle = near_diagonal ? angle + std::numbers::pi / 4 : angle;
  angle = across > along ? std::numbers::pi / 2 - angle : angle;
  angle = x < 0 ? std::numbers::pi - angle : angle;
  return y < 0 ? -angle : angle;
}

/// A vector of which each lane holds one.
struct Vector {
  double x, y, z;
};
PFV_INLINE Vector operator+(const Vector& a, const Vector& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
PFV_INLINE Vector operator-(const Vector& a, const Vector& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
PFV_INLINE Vector operator*(double s, const Vector& a) {
  return {s * a.x, s * a.y, s * a.z};
}
PFV_INLINE double dot(const Vector& a, const Vector& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
PFV_INLINE Vector cross(const Vector& a, const Vector& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
PFV_INLINE double norm(const Vector& a) {
  return std::sqrt(dot(a, a));
}

} // namespace pfv::lanes
