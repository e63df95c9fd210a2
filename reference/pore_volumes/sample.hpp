#pragma once

#include "pfv/flow/steady_flow.hpp"
#include "reference/answer.hpp"
#include "reference/probes.hpp"

namespace reference {

/// Pressures of the pores that contain the points, and fluxes through the throats when `probes` are those of
/// pore_probes; facets of other probes are left unknown.
void sample(const pfv::SteadyFlow& flow, const Probes& probes, Answer& answer);

} // namespace reference
