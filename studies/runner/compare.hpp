#pragma once

#include "studies/runner/finding.hpp"
#include "studies/runner/outcome.hpp"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace studies {

/// Relative differences up to which two methods are said to agree.
struct Tolerance {
  double permeability = 0.05;
  double forces = 0.05;

  bool operator==(const Tolerance&) const = default;
};

/// A relative difference from the reference. 0.1 is 10 %.
struct Difference {
  double value = 0;
  std::optional<double> error;           // of the difference: both error bars added, each relative to the reference
  std::optional<double> reference_error; // relative; nothing when the reference has no error bar

  /// A difference below the reference's own error says nothing.
  bool unresolved() const;
  bool operator==(const Difference&) const = default;
};

/// One method against the reference on one case.
struct Comparison {
  std::string case_id;
  std::string method;
  std::string reference;
  std::optional<Outcome> outcome;         // nothing for the reference itself and for what was not run
  std::string because;                    // one sentence without a full stop
  std::optional<Difference> permeability; // (k - k_ref) / k_ref
  std::optional<Difference> forces;       // rms_difference
};

/// sqrt(sum |F - F_ref|^2 / sum |F_ref|^2) over all spheres. Throws pfv::InputError unless both have the same spheres.
double rms_difference(std::span<const pfv::Vec3> forces, std::span<const pfv::Vec3> reference);

/// `reference` is what the reference method found on the same case; pass a null pointer when it was not asked.
Comparison compare(const Finding& finding, const std::string& reference_method, const Finding* reference,
                   const Tolerance& tolerance);

} // namespace studies
