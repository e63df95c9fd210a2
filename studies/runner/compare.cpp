#include "studies/runner/compare.hpp"

#include "pfv/problem/error.hpp"
#include "studies/runner/number_text.hpp"

#include <fmt/format.h>

#include <algorithm>
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

std::optional<Difference> rms_of(const std::optional<BoundedField>& field, const std::optional<BoundedField>& reference,
                                 bool no_mesh, std::optional<double> scale = std::nullopt) {
  if (!field || !reference)
    return std::nullopt;
  const double unit = scale.value_or(rms(reference->values));
  const auto relative = [&](std::optional<double> error) {
    return error ? std::optional(*error / unit) : std::nullopt;
  };
  const auto reference_error = relative(reference->error);
  const double difference = rms_difference(field->values, reference->values);
  return Difference{difference == 0 ? 0 : difference / unit,
                    no_mesh ? reference_error : sum(relative(field->error), reference_error), reference_error};
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
  // A method without a mesh has no discretisation error of its own: the reference's is all there is.
  const bool no_mesh = !finding.told().convergence_order;
  comparison.forces = rms_of(finding.forces, reference.forces, no_mesh);
  comparison.fluxes = rms_of(finding.throat_fluxes, reference.throat_fluxes, no_mesh);
  if (reference.pressure_drop && finding.pore_pressures && reference.pore_pressures) {
    const bool free_level = finding.free_level || reference.free_level;
    comparison.pressures =
        rms_of(free_level ? at_level_of(*reference.pore_pressures, *finding.pore_pressures) : *finding.pore_pressures,
               reference.pore_pressures, no_mesh, reference.pressure_drop);
  }
  if (!comparison.permeability && !comparison.forces) {
    comparison.outcome = Outcome::not_covered;
    comparison.because = fmt::format("no quantity in common with {}", comparison.reference);
    return;
  }
  bool all_agree = true;
  const auto judge = [&](const std::optional<Difference>& difference, const char* quantity, double allowed) {
    if (!difference)
      return;
    all_agree = all_agree && agrees(*difference, allowed);
    comparison.because += (comparison.because.empty() ? "" : "; ") + told(*difference, quantity, allowed);
  };
  judge(comparison.permeability, "permeability", tolerance.permeability);
  judge(comparison.forces, "rms force", tolerance.forces);
  judge(comparison.pressures, "rms pore pressure", tolerance.pressures);
  comparison.outcome = all_agree ? Outcome::agrees : Outcome::differs;
}

} // namespace

BoundedField at_level_of(const BoundedField& reference, BoundedField field) {
  double sum = 0;
  std::size_t known = 0;
  for (std::size_t i = 0; i < std::min(field.values.size(), reference.values.size()); ++i)
    if (const double difference = field.values[i] - reference.values[i]; !std::isnan(difference)) {
      sum += difference;
      ++known;
    }
  for (double& value : field.values)
    value -= sum / static_cast<double>(std::max<std::size_t>(known, 1));
  return field;
}

bool Difference::unresolved() const {
  return reference_error && std::abs(value) < *reference_error;
}

double rms(std::span<const double> values) {
  const std::vector<double> nothing(values.size(), 0);
  return rms_difference(values, nothing);
}

double rms_difference(std::span<const double> values, std::span<const double> reference) {
  if (values.size() != reference.size())
    throw pfv::InputError(fmt::format("{} and {} values cannot be compared", values.size(), reference.size()));
  double squares = 0;
  std::size_t known = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double difference = values[i] - reference[i];
    if (std::isnan(difference))
      continue;
    squares += difference * difference;
    ++known;
  }
  return known > 0 ? std::sqrt(squares / static_cast<double>(known)) : 0;
}

Comparison compare(const Finding& finding, const std::string& reference_method, const Finding* reference,
                   const Tolerance& tolerance) {
  Comparison comparison{finding.case_id, finding.method, reference_method, std::nullopt, {}, {}, {}, {}, {}};
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
