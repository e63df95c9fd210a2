#pragma once

#include "reference/stokes_fem/stokes_solver.hpp"

#include <filesystem>
#include <string>

namespace reference::stokes_fem {

/// What ranks say of a flow beside the flow itself, in units of the unit case.
struct RanksReply {
  std::array<double, 6> face_flux{};
  double dissipation = 0;
  double residual = 0;
  double imbalance = 0;
  int iterations = 0;
  std::size_t velocity_nodes = 0;
  std::size_t pressure_nodes = 0;
  std::size_t free_velocities = 0;
  double assemble_seconds = 0; // CPU, all ranks
  double factor_seconds = 0;
  double solve_seconds = 0;
  double peak_memory = 0; // bytes, all ranks
};

/// As JSON, numbers with the digits that read back to the same double. Reading throws std::exception.
std::string to_json(const RanksReply& reply);
RanksReply ranks_reply_from_json(const std::string& text);

/// A flow by node, in the numbers of discretise() for the same mesh, as doubles in the machine's own format.
/// Throws std::runtime_error when the file cannot be written, or read as one of these sizes.
void write_flow(const FlowField& flow, const std::filesystem::path& file);
FlowField read_flow(const std::filesystem::path& file, std::size_t velocity_nodes, std::size_t pressure_nodes);

} // namespace reference::stokes_fem
