#pragma once

#include "reference/lattice_boltzmann/lattice_flow/palabos.hpp"
#include "reference/lattice_boltzmann/lattice_flow/stokes_collision.hpp"

namespace reference::lattice_boltzmann {

using Lattice = plb::MultiBlockLattice3D<double, plb::descriptors::D3Q19Descriptor>;
using Block = plb::BlockLattice3D<double, plb::descriptors::D3Q19Descriptor>;
using Cell = plb::Cell<double, plb::descriptors::D3Q19Descriptor>;
using Solid = plb::NoDynamics<double, plb::descriptors::D3Q19Descriptor>;

/// StokesCollision as Palabos' lattices call it. Palabos fills the rims of blocks with copies that it makes by number,
/// from what serialize() wrote.
class StokesDynamics final : public plb::IsoThermalBulkDynamics<double, plb::descriptors::D3Q19Descriptor> {
public:
  explicit StokesDynamics(const StokesCollision& collision)
      : IsoThermalBulkDynamics(collision.even()), collision_(collision) {}
  explicit StokesDynamics(plb::HierarchicUnserializer& text) : StokesDynamics(read(text)) {}

  StokesDynamics* clone() const override { return new StokesDynamics(*this); }
  int getId() const override { return number; }
  void serialize(plb::HierarchicSerializer& text) const override {
    text.addValue(collision_.viscosity());
    text.addValue(collision_.magic());
    for (const double component : collision_.force())
      text.addValue(component);
  }
  void collide(Cell& cell, plb::BlockStatistics&) override { collision_(cell); }
  double computeEquilibrium(plb::plint direction, double rho, const plb::Array<double, 3>& j, double,
                            double) const override {
    const auto d = static_cast<std::size_t>(direction);
    return weight(d) * (rho + 3 * (steps[d][0] * j[0] + steps[d][1] * j[1] + steps[d][2] * j[2]));
  }

private:
  static StokesCollision read(plb::HierarchicUnserializer& text) {
    const auto next = [&] { return text.readValue<double>(); };
    const double viscosity = next();
    const double magic = next();
    return {viscosity, magic, {next(), next(), next()}};
  }

  static inline const int number =
      plb::meta::registerGeneralDynamics<double, plb::descriptors::D3Q19Descriptor, StokesDynamics>("Stokes");
  StokesCollision collision_;
};

} // namespace reference::lattice_boltzmann
