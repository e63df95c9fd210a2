#pragma once

#include "pfv/flow/flow_system.hpp"
#include "pfv/simulation/solid_flux.hpp"
#include "pfv/solvers/gram_term.hpp"

namespace pfv {

/// step B M^-1 B^T over the unknowns of the system: what the solid carries out of pores because pressures push it for
/// a step (s). `per_mass` is 1 / mass by body (1/kg).
GramTerm solid_term(const SolidFlux& flux, const FlowSystem& system, std::span<const double> per_mass, double step);

} // namespace pfv
