#pragma once

#include "pfv/problem/packing.hpp"

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace reference::lattice_boltzmann {

/// How the box goes on past its two faces across one axis.
enum class Beyond {
  repeats,     // periodic
  is_mirrored, // slip walls: planes of symmetry
  is_opposed   // pressure faces: mirrored with the signs of velocity and pressure changed
};

/// What the solver is asked, in lattice units: the length of a voxel, one time step, the density 1. The box reaches
/// from zero to `voxels`; the centres of its voxels lie at halves.
struct FlowQuestion {
  std::array<int, 3> voxels{};
  std::array<Beyond, 3> beyond{};
  int axis = 0; // along which a force of 1 per voxel drives the fluid
  std::vector<pfv::Sphere> spheres;
  double viscosity = 0.5;
  double magic = 3. / 16;   // (tau+ - 1/2) (tau- - 1/2)
  double tolerance = 1e-5;  // of the mean velocity and of the balance of forces, relative
  int most_steps = 1000000; // given up past them
  std::vector<pfv::Vec3> points;
  std::vector<std::vector<pfv::Vec3>> facets;
};

/// Its answer. What is not known at a place is NaN.
struct FlowReply {
  std::size_t fluid_voxels = 0;
  std::size_t pocket_voxels = 0;    // of fluid that cannot flow, counted as solid
  std::size_t links = 0;            // from fluid to solid voxels
  std::size_t narrow_links = 0;     // with no fluid voxel behind: bounced back half-way
  std::vector<double> solid_voxels; // by sphere
  int steps = 0;
  bool settled = false;
  double velocity = 0;                      // mean over the whole box along the axis
  std::array<double, 2> section_velocity{}; // the smallest and largest mean over a section across the axis
  double balance = 0;                       // force on the fluid not taken up by the spheres, relative
  double drift = 0;                         // change of the mean velocity still expected, relative
  std::vector<pfv::Vec3> forces;            // by sphere, without the driving gradient's own
  std::vector<double> pressures;            // at points, without the driving gradient
  std::vector<double> fluxes;               // through facets
  double voxel_seconds = 0;                 // CPU, all ranks
  double solve_seconds = 0;
  double peak_memory = 0; // bytes, all ranks
};

/// As JSON, numbers with the digits that read back to the same double. Reading throws std::exception.
std::string to_json(const FlowQuestion& question);
std::string to_json(const FlowReply& reply);
FlowQuestion flow_question_from_json(const std::string& text);
FlowReply flow_reply_from_json(const std::string& text);

} // namespace reference::lattice_boltzmann
