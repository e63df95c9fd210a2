#pragma once

#include "pfv/grains/contact_law.hpp"
#include "pfv/problem/packing.hpp"

#include <optional>

namespace studies {

/// Why the stock program cannot be run here; nothing when it can.
std::optional<std::string> missing_liggghts();

/// What LIGGGHTS (DCS Computing's; Debian package liggghts) took for steps of dry grains between six fixed walls.
struct LiggghtsRun {
  double cpu_seconds = 0;    // of a step
  double kinetic_energy = 0; // J, after the warm-up
};

/// Steps of the same grains under the same law, with the friction of grains between them and the walls too. CPU seconds
/// are those of a process that does `warm_up` and `steps`, less those of one that does the warm-up only. The law has
/// constant springs or those of Hertz and Mindlin. Throws pfv::SolveError with the program's last words when it fails.
LiggghtsRun run_liggghts(const pfv::Packing& packing, const pfv::ContactLaw& law, double density, double step,
                         std::size_t warm_up, std::size_t steps);

} // namespace studies
