#pragma once

#include "pfv/simulation/simulation.hpp"

#include <string>
#include <vector>

namespace pfv {

/// What the scene names, in words, with its parameters: all that is computed.
std::vector<std::string> effects_of(const Scene& scene);

/// Effects, limits and step, before the run.
std::string opening_report(const Scene& scene, const Simulation& simulation);
/// Where the run has come to: energies, stages.
std::string closing_report(const Simulation& simulation);
std::string json_report(const Scene& scene, const Simulation& simulation);

/// One line of the history and its header (CSV): time, box, contacts, energies, mean pressure.
std::string history_header();
std::string history_row(const Simulation& simulation);

} // namespace pfv
