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
  double pressures = 0.05; // of the pressure drop

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
  std::optional<Difference> forces;       // rms, of the rms force on the spheres
  std::optional<Difference> pressures;    // rms over the pores, of the pressure drop
  std::optional<Difference> fluxes;       // rms, of the rms flux through throats: told, not judged
};

/// Root mean square of values, and of differences, over what is known of them. Throws pfv::InputError unless both are
/// of one length.
double rms(std::span<const double> values);
double rms_difference(std::span<const double> values, std::span<const double> reference);

/// The field moved by a constant so that its mean is the reference's, over the places where both are known.
BoundedField at_level_of(const BoundedField& reference, BoundedField field);

/// `reference` is what the reference method found on the same case; pass a null pointer when it was not asked.
Comparison compare(const Finding& finding, const std::string& reference_method, const Finding* reference,
                   const Tolerance& tolerance);

} // namespace studies
