#pragma once

#include "pfv/simulation/simulation.hpp"
#include "studies/motion/stability/trial.hpp"

#include <Eigen/Core>

namespace studies {

// What the original implementation does with grains that move, see original.hpp.

/// By how much it resists the motion of spheres, see pfv::resistance: found by moving one after the other. Without the
/// spheres nearest to the corners of the box. Or in words why there is nothing.
struct OriginalResistance {
  std::optional<Eigen::MatrixXd> matrix;
  std::string why_not;
};
OriginalResistance original_resistance(const pfv::Packing& packing);

/// Its oedometer on grains like those of the scene, in steps of each of these shares of the viscous limit that we
/// predict.
Theirs original_steps(const pfv::Scene& scene, const std::vector<double>& shares);

} // namespace studies
