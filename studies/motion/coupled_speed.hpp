#pragma once

#include "pfv/simulation/pore_fluid.hpp"
#include "studies/motion/dry_speed.hpp"

namespace studies {

/// The original implementation's own example of a consolidation, 5000 grains in a box of 1 m under a drained piston, by
/// us and by YADE: the same packing, springs, load, viscosity and step, explicit.
struct CoupledSpeed {
  int grains = 0;
  std::size_t pores = 0;
  std::string version;                         // of YADE
  double step = 0;                             // s, of both
  std::size_t steps = 0;                       // of a turn
  Turns ours;                                  // CPU seconds of a step
  std::optional<Turns> theirs;                 // nothing where YADE is not installed
  double settlement = 0, their_settlement = 0; // m, after the steps
  double our_step = 0;                         // s, that we choose ourselves,
  Turns at_our_step;                           // and what one of them takes
  std::vector<pfv::Stage> stages;              // ours, of the last turn at the common step
  pfv::FluidState::Counts counts{};            // of it
};

CoupledSpeed coupled_speed(int grains, std::size_t steps, int turns, const Say& say);

} // namespace studies
