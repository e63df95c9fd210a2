#pragma once

#include "studies/motion/experiment.hpp"

#include <optional>
#include <vector>

namespace studies {

/// CPU seconds of one step in several turns.
struct Turns {
  std::vector<double> cpu_seconds;

  double median() const;
};

/// Dry grains between fixed walls under one law, by us and by LIGGGHTS: the same packing, law, walls and step.
struct DrySpeed {
  int grains = 0;
  std::size_t contacts = 0; // of grains, at the start
  std::string_view law;
  double step = 0; // s
  Turns ours;
  std::optional<Turns> theirs;             // nothing where LIGGGHTS is not installed
  double our_energy = 0, their_energy = 0; // J, kinetic, after the warm-up
  std::vector<pfv::Stage> stages;          // ours, of the last turn
  std::size_t steps = 0;                   // of a turn
};

/// Random grains pressed together by a piston until they rest. Then the piston stays, and the packing goes on under
/// each of the laws: constant springs and those of Hertz and Mindlin.
std::vector<DrySpeed> dry_speeds(int grains, std::size_t steps, int turns, const Say& say);

} // namespace studies
