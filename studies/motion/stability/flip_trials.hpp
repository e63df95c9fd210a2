#pragma once

#include "studies/motion/stability/trial.hpp"

namespace studies {

/// A sphere moves across the place where the triangulation around it changes: forces just before and just after. The
/// original is asked at the same two places.
std::vector<Trial> flip_trials();

/// Grains that have parted as far as pores are let follow them: forces before and after these are triangulated anew.
std::vector<Trial> renewal_trials();

/// Motion that hardly changes from step to step, so that pressures do not either: forces after 400 steps against those
/// of a fluid that starts there.
std::vector<Trial> steady_motion_trials();

} // namespace studies
