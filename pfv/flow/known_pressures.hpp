#pragma once

#include "pfv/flow/pore_groups.hpp"
#include "pfv/pores/pore_network.hpp"
#include "pfv/problem/case.hpp"

#include <span>
#include <vector>

namespace pfv {

/// Where the pressure is known beforehand, and from what: sources are numbered by index(Face), pressure points follow.
struct KnownPressures {
  static constexpr int no_source = -1;

  std::vector<int> source;   // by pore; the same for all of a group
  std::vector<double> value; // Pa, by pore, as at the first pore of its group; zero without a source
  double mean = 0;           // Pa, over the sources
};

/// A pore that touches an open face has its centre on it and so its pressure, and so have all pores of its group; a
/// pore that contains a pressure point has that. On a Flux face the pressure is taken to be zero. `rise` (Pa) is by how
/// much the pressure rises from one box to the next along each axis. Throws SolveError when different pressures meet.
KnownPressures known_pressures(const PoreNetwork& network, const FaceConditions& faces,
                               std::span<const PressurePoint> points, const Vec3& rise, PoreGroups& groups);

/// The pressure of an open face at a pore that touches it (Pa); nothing on walls and periodic faces.
std::optional<double> pressure_at(const FaceCondition& condition, const Vec3& centre);

} // namespace pfv
