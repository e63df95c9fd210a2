#pragma once

#include "pfv/grains/contact_list.hpp"
#include "pfv/problem/generate.hpp"
#include "pfv/simulation/drained_box.hpp"
#include "pfv/simulation/energy_account.hpp"

namespace pfv::testing {

inline double height(const Simulation& simulation) {
  return simulation.grains().grains.packing.box.size().z();
}

/// Takes the steps, then what EnergyAccount finds of the work of the loads.
inline double energy_balance(Simulation& simulation, int steps) {
  EnergyAccount account(simulation);
  for (int n = 0; n < steps; ++n)
    account.advance();
  return account.accounted();
}

} // namespace pfv::testing
