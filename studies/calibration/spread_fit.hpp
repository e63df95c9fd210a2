#pragma once

#include "pfv/flow/conductance_rules.hpp"
#include "studies/calibration/known_flow.hpp"

#include <span>
#include <vector>

namespace studies {

/// The share of shear that neighbours even out (pfv/flow/shear_spread.hpp), as fitted to forces on spheres.
struct SpreadFit {
  double share, standard_error;
  // Difference of the forces from the known ones, rms over rms, by packing:
  std::vector<double> by_throat; // with a share of 0
  std::vector<double> fitted;
  std::vector<double> left_out; // with the share that all other packings give
};

/// Least squares of the forces over the share, in units of each packing's rms force, all packings alike. Pressures and
/// conductances are those of the rule. Throws pfv::InputError with fewer than two packings.
SpreadFit fit_shear_spread(std::span<const KnownFlow> packings, const pfv::Calibrated& rule);

} // namespace studies
