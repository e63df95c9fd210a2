#pragma once

#include "pfv/problem/case.hpp"

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace reference::yade {

/// CPU seconds of one call of FlowEngine, as its own timers share them out.
struct Iteration {
  double network = 0; // triangulation, geometry, conductances
  double solve = 0;   // matrix, factors, solution: in a repeated call the last only
  double forces = 0;  // and all that is left
};

struct Reply {
  std::string version;
  std::size_t cells = 0;
  double flux_in = 0;            // m^3/s through the upper face, signed like the pressure drop
  double flux_out = 0;           // m^3/s through the lower face
  std::vector<pfv::Vec3> forces; // N, by sphere
  std::vector<double> pressures; // Pa, of the cells that contain the points; NaN where it says nothing
  Iteration first;               // from the spheres to the forces on them
  Iteration repeated;            // nothing has moved: topology, conductances and factors are kept
  double memory_before = 0;      // bytes of YADE and its scene before the first call
  double peak_memory = 0;        // bytes, of the whole process
};

/// One permeability setup by FlowEngine, in a process of its own that is stopped after `wall_limit` (s). It is asked
/// with the box's length, the pressure drop and the viscosity as units: its clamp on conductances depends on the unit
/// of length, by 14 % in the permeability of 200 spheres between 1 m and 1 cm. Throws pfv::SolveError when it crashes
/// or when what it says is not finite.
Reply run_flow_engine(const pfv::Case& problem, std::span<const pfv::Vec3> points, double wall_limit);

} // namespace reference::yade
