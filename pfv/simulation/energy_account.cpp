#include "pfv/simulation/energy_account.hpp"

#include "pfv/grains/contact_list.hpp"

namespace pfv {
namespace {

double springs_of(const Simulation& simulation) {
  return elastic_energy(simulation.grains().grains, simulation.grains().contacts);
}

} // namespace

EnergyAccount::EnergyAccount(Simulation& simulation)
    : simulation_(simulation), elastic_before_(springs_of(simulation)) {}

void EnergyAccount::advance() {
  elastic_before_ = springs_of(simulation_);
  simulation_.advance();
}

double EnergyAccount::kinetic() const {
  return kinetic_energy(simulation_.grains().grains, simulation_.grains().scene.walls);
}

double EnergyAccount::elastic() const {
  return 0.5 * (elastic_before_ + springs_of(simulation_));
}

double EnergyAccount::accounted() const {
  const EnergyBalance& energy = simulation_.grains().energy;
  return (kinetic() + elastic() + energy.lost()) / (energy.loads + energy.growth);
}

} // namespace pfv
