#pragma once

#include "pfv/flow/steady_flow.hpp"

#include <string>

namespace pfv {

/// The answer as a page of text.
std::string text_report(const Case& problem, const FlowOptions& options, const SteadyFlow& flow, const Clock& clock);

/// The answer as one JSON object, SI units. `permeability` is null when the case is no permeability test. Only there
/// when asked: `face_pressure` of faces with an imposed flux, `point_flux` of pressure points, `mean_flux` of a
/// periodic box, `notes` of the packing's reader.
std::string json_report(const Case& problem, const FlowOptions& options, const SteadyFlow& flow, const Clock& clock);

} // namespace pfv
