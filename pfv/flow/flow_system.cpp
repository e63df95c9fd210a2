#include "pfv/flow/flow_system.hpp"

#include "pfv/flow/known_pressures.hpp"
#include "pfv/flow/link_matrix.hpp"
#include "pfv/flow/pore_groups.hpp"

#include <algorithm>

namespace pfv {
namespace {

Shift shift_of(const PoreNetwork::Throats& throats, std::size_t t) {
  return throats.shift.empty() ? Shift{} : throats.shift[t];
}

PoreGroups contract(const PoreNetwork& network, double median, FlowSystem& system) {
  const auto& throats = network.throats;
  PoreGroups groups(network.pores.size(), !throats.shift.empty());
  system.contracted.assign(throats.size(), false);
  for (std::size_t t = 0; t < throats.size(); ++t)
    if (system.conductance[t] > FlowSystem::contraction * median) {
      groups.join(throats.pores[t][0], throats.pores[t][1], shift_of(throats, t));
      system.conductance[t] = 0;
      system.contracted[t] = true;
      ++system.contracted_throats;
    }
  if (!throats.shift.empty()) {
    system.offset.resize(network.pores.size());
    for (std::size_t i = 0; i < system.offset.size(); ++i)
      system.offset[i] = groups.offset(static_cast<int>(i));
  }
  return groups;
}

PoreGroups connected_parts(const PoreNetwork& network, const FlowSystem& system, PoreGroups groups) {
  const auto& throats = network.throats;
  for (std::size_t t = 0; t < throats.size(); ++t)
    if (system.conductance[t] > 0)
      groups.join(throats.pores[t][0], throats.pores[t][1], shift_of(throats, t));
  return groups;
}

/// Numbers the groups that some path of open throats joins to a known pressure, or to fluid that sets its own, after
/// holding one pore of every part that has neither but is driven from box to box. The others are isolated.
int number_unknowns(const PoreNetwork& network, const KnownPressures& known, Isolated isolated, PoreGroups& groups,
                    FlowSystem& system) {
  constexpr int of_known = -1, of_isolated = -2;
  const int count = static_cast<int>(network.pores.size());
  PoreGroups parts = connected_parts(network, system, groups);
  std::vector<bool> has_level(count, false);
  for (int i = 0; i < count; ++i)
    if (known.source[i] >= 0 || (isolated == Isolated::unknown && network.pores.void_volume[i] > 0))
      has_level[parts.find(i)] = true;

  int unknowns = 0;
  std::vector<int> number(count, of_isolated);
  system.unknown_of_pore.resize(count);
  for (int i = 0; i < count; ++i) {
    const int part = parts.find(i);
    int& of_group = number[groups.find(i)];
    if (known.source[i] >= 0) {
      of_group = of_known;
    } else if (of_group == of_isolated && has_level[part]) {
      of_group = unknowns++;
    } else if (of_group == of_isolated && !system.rise.isZero(0)) {
      of_group = of_known;
      has_level[part] = true;
      ++system.held_pores;
    }
    system.unknown_of_pore[i] = of_group >= 0 ? of_group : ~static_cast<int>(system.known_pores.size());
    if (of_group < 0)
      system.known_pores.push_back({known.source[i], of_group == of_isolated ? known.mean : known.value[i]});
    system.isolated_pores += of_group == of_isolated;
  }
  return unknowns;
}

/// Hands every open throat, with the unknowns it joins, to `link`.
auto links(const PoreNetwork& network, const FlowSystem& system) {
  return [&](const auto& link) {
    for (std::size_t t = 0; t < network.throats.size(); ++t)
      if (system.conductance[t] > 0)
        link(system.unknown_of_pore[network.throats.pores[t][0]], system.unknown_of_pore[network.throats.pores[t][1]],
             system.conductance[t]);
  };
}

void fill_right_side(const PoreNetwork& network, FlowSystem& system) {
  system.right_side.setZero();
  for (std::size_t t = 0; t < network.throats.size(); ++t) {
    const double k = system.conductance[t];
    const auto [i, j] = network.throats.pores[t];
    const int a = system.unknown_of_pore[i], b = system.unknown_of_pore[j];
    if (a >= 0 && b >= 0 && system.offset.empty())
      continue;
    const double rise = along(system.rise, crossing(system, network, t));
    const auto above_level = [&](const FlowSystem::KnownPore* pore) {
      return pore != nullptr ? pore->pressure - system.level : 0;
    };
    if (a >= 0)
      system.right_side[a] += k * (rise + above_level(system.known(j)));
    if (b >= 0)
      system.right_side[b] -= k * (rise - above_level(system.known(i)));
  }
}

} // namespace

FlowSystem assemble(const PoreNetwork& network, Conductances conductances, const FaceConditions& faces,
                    std::span<const PressurePoint> points, Isolated isolated) {
  FlowSystem system;
  system.faces = faces;
  system.points = points.size();
  system.rise = imposed_gradient(faces).cwiseProduct(network.box.size());
  system.conductance = std::move(conductances.values);
  system.rounded_throats = conductances.rounded;
  PoreGroups groups = contract(network, conductances.median, system);
  int unknowns = 0;
  {
    const KnownPressures known = known_pressures(network, faces, points, system.rise, groups);
    system.level = known.mean;
    unknowns = number_unknowns(network, known, isolated, groups, system);
  }
  system.matrix = matrix_of(unknowns, links(network, system));
  system.right_side.resize(unknowns);
  fill_right_side(network, system);
  return system;
}

bool has_way(const FlowSystem& system, const PoreNetwork& network) {
  if (!system.rise.isZero(0))
    return true;
  const auto& throats = network.throats;
  PoreGroups parts(network.pores.size(), !throats.shift.empty());
  for (std::size_t t = 0; t < throats.size(); ++t)
    if (system.contracted[t] || system.conductance[t] > 0)
      parts.join(throats.pores[t][0], throats.pores[t][1], shift_of(throats, t));
  std::vector<const FlowSystem::KnownPore*> imposed(network.pores.size(), nullptr);
  for (std::size_t i = 0; i < imposed.size(); ++i)
    if (const auto* known = system.known(i); known && known->source >= 0) {
      auto& of_part = imposed[parts.find(static_cast<int>(i))];
      if (of_part && of_part->pressure != known->pressure)
        return true;
      of_part = known;
    }
  return false;
}

void renew_right_side(FlowSystem& system, const PoreNetwork& network) {
  fill_right_side(network, system);
}

void impose(FlowSystem& system, Face face, double pressure) {
  for (FlowSystem::KnownPore& pore : system.known_pores)
    if (pore.source == index(face))
      pore.pressure = pressure;
}

namespace {

bool has_profile(const FaceConditions& faces) {
  return std::ranges::any_of(faces, [](const auto& face) { return std::holds_alternative<PressureProfile>(face); });
}

/// Whether it could: a pore away from the face whose group has a profile's pressure does not know where from.
bool impose_again(FlowSystem& system, const PoreNetwork& network) {
  for (const Face face : all_faces)
    if (std::holds_alternative<Flux>(system.faces[index(face)]))
      impose(system, face, 0);
  if (!has_profile(system.faces))
    return true;
  for (const auto& part : network.wall_parts)
    if (const auto* known = system.known(part.pore); known && known->source == index(part.face))
      system.known_pores[~system.unknown_of_pore[part.pore]].pressure =
          *pressure_at(system.faces[index(part.face)], network.pores.centre[part.pore]);
  return system.contracted_throats == 0;
}

} // namespace

bool refresh(FlowSystem& system, const PoreNetwork& network, const Conductances& conductances) {
  const double wide_open = FlowSystem::wide_open * conductances.median;
  const double most = FlowSystem::contraction * conductances.median;
  for (std::size_t t = 0; t < conductances.values.size(); ++t) {
    const double k = conductances.values[t];
    if (system.contracted[t]) {
      if (k < wide_open)
        return false;
      continue;
    }
    if ((k > 0) != (system.conductance[t] > 0))
      return false;
    system.conductance[t] = std::min(k, most);
  }
  system.rounded_throats = conductances.rounded;
  system.rise = imposed_gradient(system.faces).cwiseProduct(network.box.size());
  if (!impose_again(system, network))
    return false;
  if (!system.places && !(system.places = places_of(system.matrix, links(network, system))))
    return false;
  refill(system.matrix, *system.places, links(network, system));
  fill_right_side(network, system);
  return true;
}

void set_pore_pressures(const FlowSystem& system, const Eigen::VectorXd& solution, std::vector<double>& pressure) {
  pressure.resize(system.unknown_of_pore.size());
  for (std::size_t i = 0; i < pressure.size(); ++i) {
    const auto* known = system.known(i);
    pressure[i] = known ? known->pressure : system.level + solution[system.unknown_of_pore[i]];
    if (!system.offset.empty())
      pressure[i] -= along(system.rise, system.offset[i]);
  }
}

std::vector<double> pore_pressures(const FlowSystem& system, const Eigen::VectorXd& solution) {
  std::vector<double> pressure;
  set_pore_pressures(system, solution, pressure);
  return pressure;
}

} // namespace pfv
