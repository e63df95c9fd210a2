#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
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

/// Natural logarithm of a positive normal number as std::log gives it, to 3e-16 of the larger of it and 1: the exponent
/// by its bits, the logarithm of what is left, between sqrt(1/2) and sqrt(2), by the series of 2 artanh.
PFV_INLINE double log(double x) {
  constexpr std::uint64_t half_root = 0x3fe6a09e667f3bcd; // bits of sqrt(1/2)
  constexpr double offset = 0x1p52 + 0x1p11;              // makes a double of twelve bits with a sign
  const auto bits = std::bit_cast<std::uint64_t>(x);
  const std::uint64_t above = bits - half_root;
  const double rest = std::bit_cast<double>(bits - (above & 0xfff0000000000000));
  const double exponent = std::bit_cast<double>(((above >> 52) ^ 0x800) | 0x4330000000000000) - offset;
  const double f = (rest - 1) / (rest + 1), z = f * f;
  double p = 1.0 / 23;
  p = p * z + 1.0 / 21;
  p = p * z + 1.0 / 19;
  p = p * z + 1.0 / 17;
  p = p * z + 1.0 / 15;
  p = p * z + 1.0 / 13;
  p = p * z + 1.0 / 11;
  p = p * z + 1.0 / 9;
  p = p * z + 1.0 / 7;
  p = p * z + 1.0 / 5;
  p = p * z + 1.0 / 3;
  return exponent * std::numbers::ln2 + 2 * (f + f * z * p);
}

/// Exponential as std::exp gives it, to 2e-15 of itself, between -700 and 700: a power of two by its bits, the rest,
/// below ln(2) / 2, by its series.
PFV_INLINE double exp(double x) {
  constexpr double to_integer = 0x1.8p52; // adding it rounds to one, in the last bits
  constexpr double ln2_head = 0x1.62e42feep-1, ln2_tail = 0x1.a39ef35793c76p-33;
  const double shifted = x * std::numbers::log2e + to_integer, exponent = shifted - to_integer;
  const double r = (x - exponent * ln2_head) - exponent * ln2_tail;
  double p = 1.0 / 6227020800;
  p = p * r + 1.0 / 479001600;
  p = p * r + 1.0 / 39916800;
  p = p * r + 1.0 / 3628800;
  p = p * r + 1.0 / 362880;
  p = p * r + 1.0 / 40320;
  p = p * r + 1.0 / 5040;
  p = p * r + 1.0 / 720;
  p = p * r + 1.0 / 120;
  p = p * r + 1.0 / 24;
  p = p * r + 1.0 / 6;
  p = p * r + 0.5;
  p = p * r + 1;
  p = p * r + 1;
  return std::bit_cast<double>(std::bit_cast<std::uint64_t>(p) + (std::bit_cast<std::uint64_t>(shifted) << 52));
}

/// A vector of which each lane holds one.
struct Vector {
  double x, y, z;
};

/// That of one lane, of points kept coordinate by coordinate.
template <typename Points>
PFV_INLINE Vector at(const Points& points, int lane) {
  return {points.x[lane], points.y[lane], points.z[lane]};
}
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
