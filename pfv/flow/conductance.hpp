#pragma once

#include "pfv/flow/conductance_rules.hpp"
#include "pfv/flow/wall_rules.hpp"
#include "pfv/pores/pore_network.hpp"

#include <cstddef>
#include <vector>

namespace pfv {

struct Conductances {
  std::vector<double> values; // m^3/(Pa s), by throat; 0 where closed, infinite between coincident pores
  double median = 0;          // m^3/(Pa s), over the throats that follow the rule
  std::size_t rounded = 0;    // open throats whose signed void or wetted surface is lost: round tubes of their section
};

/// Conductance of every throat of a fluid of this viscosity (Pa s). The network must have openings when the rule reads
/// them.
Conductances conductances(const PoreNetwork& network, const Conductance& rule, const WallRule& walls, double viscosity);

/// The same in place: nothing is allocated for throats when the network has as many as before.
void update(Conductances& conductances, const PoreNetwork& network, const Conductance& rule, const WallRule& walls,
            double viscosity);

} // namespace pfv
