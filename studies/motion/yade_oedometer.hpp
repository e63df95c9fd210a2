#pragma once

#include "pfv/problem/packing.hpp"

#include <cstddef>
#include <string>

namespace studies {

/// An oedometer under water by YADE: a packing between walls, the upper of which is a drained piston.
struct YadeOedometer {
  double young = 1e6, tangential_ratio = 0.5, friction = 0.577, density = 2600; // Pa, -, -, kg/m^3
  double stress = 10e3, load = 1e3, viscosity = 10; // Pa at rest, Pa added under water, Pa s
  double step = 1e-4;                               // s, under water
  std::size_t steps = 0, steps_at_rest = 2000;
};

struct YadeOedometerReply {
  std::string version;
  double cpu_seconds = 0; // of a step
  double settlement = 0;  // m; NaN when it is no number
  double fastest = 0;     // m/s, of the grains after the steps; NaN when one's is no number
};

/// In a process of its own. Throws pfv::SolveError when it crashes, leaves no reply or runs past `wall_limit` (s).
YadeOedometerReply run_yade_oedometer(const pfv::Packing& packing, const YadeOedometer& question, double wall_limit);

} // namespace studies
