#pragma once

#include "pfv/flow/steady_flow.hpp"
#include "pfv/problem/case.hpp"
#include "studies/motion/stability/trial.hpp"

namespace studies {

/// Packings at rest that break pore networks, each crossed by a steady flow along z.
std::vector<Trial> steady_trials();

/// Steady flow along z under a unit drop, slip walls around, unit viscosity.
pfv::Case flow_through(const pfv::Packing& packing);
pfv::SteadyFlow solved(const pfv::Case& problem);

/// What holds a steady flow, whatever its packing.
std::vector<Measure> soundness(const pfv::Case& problem, const pfv::SteadyFlow& flow);

/// The remedies it took, counted: "12 contracted, 1 hidden".
std::string remedies(const pfv::SteadyFlow& flow);

} // namespace studies
