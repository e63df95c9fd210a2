#pragma once

#include "reference/lattice_boltzmann/flow_question.hpp"
#include "reference/lattice_boltzmann/voxel_grid.hpp"
#include "reference/method.hpp"

namespace reference::lattice_boltzmann {

/// Why the case is not answered: fluid has to be driven along one axis, by the pressures on its two faces, where
/// nothing moves along them, or by the mean gradient of a periodic axis; the other faces are slip walls or periodic.
std::optional<std::string> beyond_lattice(const pfv::Case& problem);

/// A case that is answered, in lattice units.
FlowQuestion question_of(const pfv::Case& problem, const VoxelGrid& grid, const Probes& probes);

/// What the reply says about the case, in SI: fluxes, permeability, porosity, forces, samples.
Answer answer_in_si(const pfv::Case& problem, const VoxelGrid& grid, const FlowQuestion& question,
                    const FlowReply& reply, const Probes& probes);

} // namespace reference::lattice_boltzmann
