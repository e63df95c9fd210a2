#pragma once

#include "pfv/flow/steady_flow.hpp"

#include <string>

namespace pfv {

/// The answer as a page of text.
std::string text_report(const Case& problem, const SteadyFlow& flow, const Clock& clock);

/// The answer as one JSON object, SI units. `permeability` is null when the faces are no permeability test.
std::string json_report(const Case& problem, const SteadyFlow& flow, const Clock& clock);

} // namespace pfv
