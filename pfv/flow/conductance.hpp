#pragma once

#include "pfv/pores/pore_network.hpp"

#include <cstddef>
#include <variant>
#include <vector>

namespace pfv {

/// K = alpha S_f R_h^2 / (mu l), R_h = Theta / gamma. Catalano et al. 2011, eqs. (5)-(7).
struct HydraulicRadius {
  double alpha = 0.5; // Hagen-Poiseuille in a circular tube
};
using Conductance = std::variant<HydraulicRadius>;

/// A throat cut by a slip wall is half of the throat between the packing and its mirror image: S_f, Theta and gamma are
/// cut alike, R_h and l are those of the whole throat.
struct MirrorWalls {};

/// What the original implementation (FlowEngine of YADE) does: the mirrored throat's conductance times 2^(-1/2) for one
/// wall and 1/2 for two. Kept for comparison only.
struct OriginalWalls {};
using WallRule = std::variant<MirrorWalls, OriginalWalls>;

struct Conductances {
  std::vector<double> values; // m^3/(Pa s), by throat; 0 on facets without area
  double median = 0;          // m^3/(Pa s), over the facets with area
  std::size_t raised = 0;     // throats without fluid area, raised to `floor` x median
  std::size_t rounded = 0;    // open throats whose signed void or wetted surface is lost: round tubes of their section
  static constexpr double floor = 1e-6;
};

/// Conductance of every throat. A throat of zero length between coincident pores has an infinite one.
Conductances conductances(const PoreNetwork& network, const Conductance& rule, const WallRule& walls, double viscosity);

} // namespace pfv
