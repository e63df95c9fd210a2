#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace studies {

/// One value at one mesh size.
struct Sample {
  double mesh_size;
  double value;
};

/// A value and, when it is known, how far the truth may be from it.
struct Bounded {
  double value = 0;
  std::optional<double> error; // half width, same unit; nothing when there was one mesh or no mesh at all
  std::optional<double> order; // of convergence used

  bool operator==(const Bounded&) const = default;
};

/// Factor on the distance between the finest value and the extrapolated one: Roache 1994 (J. Fluids Eng. 116, 405)
/// gives 1.25 for three meshes and a known order.
inline constexpr double extrapolation_safety = 1.25;

/// Richardson extrapolation to mesh size 0 of samples in any order, different mesh sizes, f(h) = f0 + C h^p:
///   f0 = f_fine + (f_fine - f_coarse) / ((h_coarse / h_fine)^p - 1),  error = 1.25 |f_fine - f0|.
/// With three or more meshes the finest three give p where they are sane (monotone, 0.5 <= p <= order + 1); where they
/// are not, `order` serves and the error is not less than 1.25 times the spread of the three. One sample, or no order:
/// the finest value as it is, without an error. Throws pfv::InputError without samples or with two of one mesh size.
Bounded extrapolate(std::vector<Sample> samples, std::optional<double> order);

/// Many values of one kind with one half width for all of them.
struct BoundedField {
  std::vector<double> values;  // NaN where unknown
  std::optional<double> error; // root mean square of the half widths of all that is known
};

/// As extrapolate, value by value; what is NaN on one mesh is unknown. All lists of one length, else pfv::InputError.
BoundedField extrapolate_field(std::span<const double> mesh_sizes, std::span<const std::vector<double>> fields,
                               std::optional<double> order);

} // namespace studies
