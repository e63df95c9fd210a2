#pragma once

#include "pfv/flow/conductance_rules.hpp"
#include "pfv/flow/wall_rules.hpp"
#include "pfv/solvers/flow_solver.hpp"

#include <filesystem>
#include <optional>
#include <string>

namespace pfv {

/// How the pore-scale finite volumes answer, apart from what the case asks.
struct FlowOptions {
  Conductance conductance = HydraulicRadius{};
  WallRule walls = MirrorWalls{};
  SolverChoice solver = AutoSolver{};
  bool keep_shapes = true; // of throats, when the first flow has their conductances: 32 bytes each, 56 with openings
};

/// The choices by their names, where there is one.
struct FlowOptionNames {
  std::optional<std::string> conductance;
  std::optional<std::string> walls;
  std::optional<std::string> solver;
};

/// What [pfv] of a case file says, each choice replaced by what `said` says; a bare packing says nothing. Not part of
/// the question, so not of the digest. Throws InputError that names the valid choices.
FlowOptions read_flow_options(const std::filesystem::path& question, const FlowOptionNames& said);

} // namespace pfv
