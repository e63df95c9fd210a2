#pragma once

#include "pfv/clock.hpp"
#include "pfv/flow/steady_flow.hpp"
#include "pfv/problem/case.hpp"

#include <string>

namespace pfv::testing {

inline Packing packing_from(const std::string& file) {
  return read_packing(std::string(TEST_DATA) + "/" + file);
}

inline PoreNetwork network_of(const Packing& packing, const PeriodicAxes& periodic = {}, bool openings = false) {
  Clock clock;
  return build_pore_network(packing, periodic, clock, openings);
}

/// Flow along an axis under a unit pressure drop, unit viscosity.
inline Case flow_through(const Packing& packing, Axis axis = Axis::z) {
  Case problem;
  problem.packing = packing;
  problem.faces = flow_along(axis);
  return problem;
}

inline SteadyFlow solved(const Case& problem, const FlowOptions& options = {}) {
  Clock clock;
  return solve_steady_flow(problem, options, clock);
}

inline Vec3 force_on_spheres(const SteadyFlow& flow) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t k = 0; k < flow.forces.pressure.size(); ++k)
    sum += flow.forces.of_flow(k);
  return sum;
}

} // namespace pfv::testing
