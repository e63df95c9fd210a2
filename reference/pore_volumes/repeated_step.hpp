#pragma once

#include "pfv/clock.hpp"
#include "pfv/flow/steady_flow.hpp"

#include <vector>

namespace reference {

/// CPU seconds by stage of one more step of a packing that moves: every sphere by up to a hundred-thousandth of its
/// radius in each direction, the topology kept, conductances and matrix renewed, the last pressures to start from. The
/// cheaper of a step away and a step back; nothing when the flow cannot be followed. Leaves `flow` where it was, to its
/// tolerance.
std::vector<pfv::Stage> repeated_step(pfv::FollowedFlow& flow, const pfv::Packing& packing);

} // namespace reference
