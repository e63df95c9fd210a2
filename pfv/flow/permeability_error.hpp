#pragma once

#include "pfv/flow/flow_options.hpp"
#include "pfv/problem/packing.hpp"

#include <optional>
#include <string>

namespace pfv {

/// How far off Stokes flow a permeability is because of its conductance rule.
struct PermeabilityError {
  std::optional<double> relative; // nine in ten packings of this kind are nearer
  std::string outside;            // of what the rule was fitted to: why there is no number
};

/// Of a rule that was fitted to Stokes flow; nothing is known of the others.
std::optional<PermeabilityError> permeability_error(const FlowOptions& options, const Packing& packing,
                                                    double porosity);

} // namespace pfv
