#include "pfv/flow/flow_system.hpp"

#include "pfv/flow/pore_groups.hpp"
#include "pfv/problem/error.hpp"

#include <fmt/format.h>
#include <numeric>

namespace pfv {
namespace {

/// Gives every pore the Pressure face it touches, and every group of contracted pores the face of any of its members.
void find_known(const PoreNetwork& network, const FaceConditions& faces, PoreGroups& groups, FlowSystem& system) {
  const std::size_t count = network.pores.size();
  std::vector<int> face_of_group(count, -1);
  for (std::size_t i = 0; i < count; ++i) {
    for (const Vertex vertex : network.pores.vertices[i]) {
      if (!is_wall(vertex))
        continue;
      const int face = index(face_of(vertex));
      const auto* pressure = std::get_if<Pressure>(&faces[face]);
      if (!pressure)
        continue;
      int& known = face_of_group[groups.find(static_cast<int>(i))];
      if (known >= 0 && std::get<Pressure>(faces[known]).value != pressure->value)
        throw SolveError(
            fmt::format("faces {} ({} Pa) and {} ({} Pa) meet in one pore: they must have the same pressure",
                        face_names[known], std::get<Pressure>(faces[known]).value, face_names[face], pressure->value));
      if (known < 0)
        known = face;
    }
  }
  system.face_of_pore.resize(count);
  system.known_pressure.assign(count, 0);
  for (std::size_t i = 0; i < count; ++i) {
    const int face = face_of_group[groups.find(static_cast<int>(i))];
    system.face_of_pore[i] = face;
    if (face >= 0)
      system.known_pressure[i] = std::get<Pressure>(faces[face]).value;
  }
}

double mean_pressure(const FaceConditions& faces) {
  double sum = 0;
  int count = 0;
  for (const auto& face : faces)
    if (const auto* pressure = std::get_if<Pressure>(&face)) {
      sum += pressure->value;
      ++count;
    }
  return count > 0 ? sum / count : 0;
}

/// Numbers the groups that some path of open throats joins to a known pressure; the others are isolated.
int number_unknowns(const PoreNetwork& network, const FaceConditions& faces, PoreGroups& groups, FlowSystem& system) {
  const std::size_t count = network.pores.size();
  PoreGroups connected = groups;
  for (std::size_t t = 0; t < network.throats.size(); ++t)
    if (system.conductance[t] > 0)
      connected.join(network.throats.pores[t][0], network.throats.pores[t][1]);
  std::vector<bool> reaches_face(count, false);
  for (std::size_t i = 0; i < count; ++i)
    if (system.face_of_pore[i] >= 0)
      reaches_face[connected.find(static_cast<int>(i))] = true;

  int unknowns = 0;
  std::vector<int> number(count, FlowSystem::isolated);
  system.unknown_of_pore.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    const int pore = static_cast<int>(i);
    int& of_group = number[groups.find(pore)];
    if (system.face_of_pore[i] >= 0)
      of_group = FlowSystem::known;
    else if (of_group == FlowSystem::isolated && reaches_face[connected.find(pore)])
      of_group = unknowns++;
    system.unknown_of_pore[i] = of_group;
    if (of_group == FlowSystem::isolated) {
      system.known_pressure[i] = mean_pressure(faces);
      ++system.isolated_pores;
    }
  }
  return unknowns;
}

void fill(const PoreNetwork& network, int unknowns, FlowSystem& system) {
  system.right_side = Eigen::VectorXd::Zero(unknowns);
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(4 * network.throats.size());
  for (std::size_t t = 0; t < network.throats.size(); ++t) {
    const double k = system.conductance[t];
    if (k == 0)
      continue;
    const auto [i, j] = network.throats.pores[t];
    const int a = system.unknown_of_pore[i], b = system.unknown_of_pore[j];
    if (a >= 0)
      entries.emplace_back(a, a, k);
    if (b >= 0)
      entries.emplace_back(b, b, k);
    if (a >= 0 && b >= 0) {
      entries.emplace_back(a, b, -k);
      entries.emplace_back(b, a, -k);
    } else if (a >= 0)
      system.right_side[a] += k * system.known_pressure[j];
    else if (b >= 0)
      system.right_side[b] += k * system.known_pressure[i];
  }
  system.matrix.resize(unknowns, unknowns);
  system.matrix.setFromTriplets(entries.begin(), entries.end());
}

} // namespace

FlowSystem assemble(const PoreNetwork& network, const Conductances& conductances, const FaceConditions& faces) {
  FlowSystem system;
  system.conductance = conductances.values;
  system.raised_throats = conductances.raised;
  PoreGroups groups(network.pores.size());
  for (std::size_t t = 0; t < network.throats.size(); ++t) {
    if (system.conductance[t] > FlowSystem::contraction * conductances.median) {
      groups.join(network.throats.pores[t][0], network.throats.pores[t][1]);
      ++system.contracted_throats;
    }
  }
  for (std::size_t t = 0; t < network.throats.size(); ++t)
    if (groups.find(network.throats.pores[t][0]) == groups.find(network.throats.pores[t][1]))
      system.conductance[t] = 0;
  find_known(network, faces, groups, system);
  fill(network, number_unknowns(network, faces, groups, system), system);
  return system;
}

std::vector<double> pore_pressures(const FlowSystem& system, const Eigen::VectorXd& solution) {
  std::vector<double> pressure = system.known_pressure;
  for (std::size_t i = 0; i < pressure.size(); ++i)
    if (system.unknown_of_pore[i] >= 0)
      pressure[i] = solution[system.unknown_of_pore[i]];
  return pressure;
}

std::array<double, 6> face_fluxes(const PoreNetwork& network, const FlowSystem& system,
                                  const std::vector<double>& pressure) {
  std::array<double, 6> flux{};
  for (std::size_t t = 0; t < network.throats.size(); ++t) {
    const auto [i, j] = network.throats.pores[t];
    const double q = system.conductance[t] * (pressure[i] - pressure[j]);
    if (system.face_of_pore[i] >= 0)
      flux[system.face_of_pore[i]] -= q;
    if (system.face_of_pore[j] >= 0)
      flux[system.face_of_pore[j]] += q;
  }
  return flux;
}

} // namespace pfv
