#include "studies/runner/compare.hpp"

#include "pfv/problem/error.hpp"
#include "studies/runner/number_text.hpp"

#include <fmt/format.h>

#include <cmath>

namespace studies {

namespace {

std::optional<double> sum(std::optional<double> a, std::optional<double> b) {
  return a && b ? std::optional(*a + *b) : std::nullopt;
}

std::optional<double> relative_error(const Bounded& bounded, double to) {
  return bounded.error ? std::optional(std::abs(*bounded.error / to)) : std::nullopt;
}

std::optional<Difference> permeability_difference(const Finding& finding, const Finding& reference) {
  if (!finding.permeability || !reference.permeability || reference.permeability->value == 0)
    return std::nullopt;
  const double k_ref = reference.permeability->value;
  const auto own_error = relative_error(*finding.permeability, k_ref);
  const auto reference_error = relative_error(*reference.permeability, k_ref);
  // A method without a mesh has no discretisation error of its own: the reference's is all there is.
  const bool no_mesh = !finding.told().convergence_order;
  return Difference{finding.permeability->value / k_ref - 1,
                    no_mesh ? reference_error : sum(own_error, reference_error), reference_error};
}

std::optional<Difference> force_difference(const Finding& finding, const Finding& reference) {
  if (!finding.forces || !reference.forces)
    return std::nullopt;
  const auto reference_error = reference.forces->relative_error;
  const bool no_mesh = !finding.told().convergence_order;
  return Difference{rms_difference(finding.forces->values, reference.forces->values),
                    no_mesh ? reference_error : sum(finding.forces->relative_error, reference_error), reference_error};
}

bool agrees(const Difference& difference, double tolerance) {
  const double size = std::abs(difference.value);
  return size <= tolerance || (difference.error && size <= *difference.error) || difference.unresolved();
}

std::string told(const Difference& difference, const char* quantity, double tolerance) {
  std::string text = fmt::format("{} {} by {}", quantity, agrees(difference, tolerance) ? "agrees: off" : "differs",
                                 percent(difference.value));
  if (difference.unresolved())
    text += fmt::format(", unresolved below the reference's own error of {}", percent(*difference.reference_error));
  else if (std::abs(difference.value) > tolerance && agrees(difference, tolerance))
    text += fmt::format(", no more than the error bars of {}", percent(*difference.error));
  else if (!difference.reference_error)
    text += ", the reference has no error bar";
  return text;
}

std::optional<Outcome> outcome_without_answer(Status status) {
  switch (status) {
  case Status::not_covered:
    return Outcome::not_covered;
  case Status::unavailable:
    return Outcome::unavailable;
  case Status::failed:
    return Outcome::failed;
  case Status::answered:
  case Status::over_budget:
    break;
  }
  return std::nullopt;
}

void compare_quantities(const Finding& finding, const Finding& reference, const Tolerance& tolerance,
                        Comparison& comparison) {
  comparison.permeability = permeability_difference(finding, reference);
  comparison.forces = force_difference(finding, reference);
  if (!comparison.permeability && !comparison.forces) {
    comparison.outcome = Outcome::not_covered;
    comparison.because = fmt::format("no quantity in common with {}", comparison.reference);
    return;
  }
  bool all_agree = true;
  if (comparison.permeability) {
    all_agree = all_agree && agrees(*comparison.permeability, tolerance.permeability);
    comparison.because = told(*comparison.permeability, "permeability", tolerance.permeability);
  }
  if (comparison.forces) {
    all_agree = all_agree && agrees(*comparison.forces, tolerance.forces);
    comparison.because +=
        (comparison.because.empty() ? "" : "; ") + told(*comparison.forces, "rms force", tolerance.forces);
  }
  comparison.outcome = all_agree ? Outcome::agrees : Outcome::differs;
}

} // namespace

bool Difference::unresolved() const {
  return reference_error && std::abs(value) < *reference_error;
}

double rms_difference(std::span<const pfv::Vec3> forces, std::span<const pfv::Vec3> reference) {
  if (forces.size() != reference.size())
    throw pfv::InputError(
        fmt::format("forces on {} and on {} spheres cannot be compared", forces.size(), reference.size()));
  double difference = 0;
  double scale = 0;
  for (std::size_t i = 0; i < forces.size(); ++i) {
    difference += (forces[i] - reference[i]).squaredNorm();
    scale += reference[i].squaredNorm();
  }
  return difference == 0 ? 0 : std::sqrt(difference / scale);
}

Comparison compare(const Finding& finding, const std::string& reference_method, const Finding* reference,
                   const Tolerance& tolerance) {
  Comparison comparison{finding.case_id, finding.method, reference_method, std::nullopt, {}, {}, {}};
  const Row& told_row = finding.told();
  if (!finding.answered()) {
    comparison.outcome = outcome_without_answer(told_row.status);
    comparison.because = told_row.message;
  } else if (finding.method == reference_method) {
    comparison.because = "the reference itself";
  } else if (!reference) {
    comparison.outcome = Outcome::unavailable;
    comparison.because = fmt::format("the reference {} was not asked", reference_method);
  } else if (!reference->answered()) {
    const Status status = reference->told().status;
    comparison.outcome = status == Status::not_covered ? Outcome::not_covered : Outcome::unavailable;
    comparison.because = fmt::format("no answer of the reference {}: {}", reference_method, name(status));
  } else {
    compare_quantities(finding, *reference, tolerance, comparison);
  }
  return comparison;
}

} // namespace studies
