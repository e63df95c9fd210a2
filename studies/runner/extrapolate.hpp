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
  double noise = 0; // half width of what in it does not fall smoothly with the mesh size, same unit
};

/// A value and, when it is known, how far the truth may be from it.
struct Bounded {
  double value = 0;
  std::optional<double> error; // half width, same unit; nothing when there was one mesh or no mesh at all
  std::optional<double> order; // of convergence used

  bool operator==(const Bounded&) const = default;
};

/// Two meshes: factor on the distance between the finest value and the extrapolated one, and the order up to which that
/// distance is taken. Two meshes do not show their order, and coarse ones have not reached it.
inline constexpr double extrapolation_safety = 1.25;
inline constexpr double unseen_order = 2;

/// Three meshes: the least error, as a share of the distance between the finest value and the extrapolated one. That
/// two pairs of meshes extrapolate to the same can be chance.
inline constexpr double least_share = 0.5;

/// Richardson extrapolation to mesh size 0 of samples in any order, different mesh sizes, f(h) = f0 + C h^p, p = order:
///   R(p) = f_fine + (f_fine - f_coarse) / (r^p - 1), r = h_coarse / h_fine.
/// What their noise makes of it is, at worst, n = (r^p n_fine + n_coarse) / (r^p - 1), and is added to its error.
/// Two samples: the error is 1.25 |f_fine - R(min(p, 2))| + n. Three or more, of which the finest three count: R' and
/// n' are the same from the coarser pair, and what is still wrong with R, as far as noise does not explain it, is taken
/// to fall as the values themselves do, with the order q that they show between 1 and p (1 where they do not approach
/// anything),
///   error = max((|R - R'| - n - n') / (r^q - 1), 0.5 |f_fine - R|) + n.
/// So the error is small where the meshes follow the order, reaches the truth where they are of a lower one down to 1,
/// and is large where they scatter by more than their noise. What it holds on cubic lattices is in calibration.csv
/// beside this file. One sample, or no order: the finest value as it is, without an error. Throws pfv::InputError
/// without samples or with two of one mesh size.
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
