#include "pfv/flow/conductance.hpp"

#include "pfv/flow/median.hpp"

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numbers>

namespace pfv {
namespace {

/// Of the mean fluid area. What is measured on slivers of 1e-12, as between spheres 1e-13 off a wall, is round-off.
constexpr double no_area = 1e-10;
/// Of a throat's fluid area: what is left of three spheres that cover the throat together, by round-off.
constexpr double no_surface = 1e-12;
constexpr double infinite = std::numeric_limits<double>::infinity();

/// Hagen-Poiseuille in a round tube of a throat's section.
double round_tube(double fluid_area, double length, double viscosity) {
  return fluid_area * fluid_area / (8 * std::numbers::pi * viscosity * length);
}

/// What the rule says, minus the conductance of a round tube where it says nothing as only the section is sound, and 0
/// where the throat is closed. By selects rather than branches, so that a loop over it vectorises.
template <typename Rule>
double conductance(const Rule& rule, const ThroatShape& throat, double viscosity, double smallest_area) {
  const double open = rule(throat, viscosity);
  const double tube = -round_tube(throat.fluid_area, throat.length, viscosity);
  const double largest = std::max(throat.fluid_area, throat.wetted_surface);
  const double surface = throat.wetted_surface - no_surface * throat.fluid_area;
  double value = std::min(throat.void_volume, surface) > 0 ? open : tube;
  value = throat.length > 0 ? value : infinite;
  value = throat.fluid_area > 0 ? value : 0;
  return largest > smallest_area ? value : 0;
}

/// A throat with its wetted surface summed by the caller.
template <typename Rule>
ThroatShape shape(const PoreNetwork::Throats& throats, std::size_t t, double wetted_surface) {
  ThroatShape throat{throats.fluid_area[t], throats.void_volume[t], wetted_surface, throats.length[t]};
  if constexpr (Rule::reads_openings) {
    throat.openness = throat.fluid_area / throats.area[t];
    throat.gap = throats.gap[t];
    throat.contrast = throats.contrast[t];
  }
  return throat;
}

template <typename Rule>
PFV_VECTORISED void fill_interior(const Rule& rule, const PoreNetwork::Throats& throats, double viscosity,
                                  double smallest_area, double* __restrict__ values) {
  for (std::size_t t = 0; t < throats.interior; ++t)
    values[t] = conductance(rule, shape<Rule>(throats, t, throats.wetted_surface[t]), viscosity, smallest_area);
}

template <typename Rule, typename Walls>
void fill_at_walls(const Rule& rule, const Walls& walls, const PoreNetwork& network, double viscosity,
                   double smallest_area, double* values) {
  const auto& throats = network.throats;
  for (std::size_t t = throats.interior; t < throats.size(); ++t) {
    double wetted = throats.wetted_surface[t];
    int cut_by = 0;
    const auto corners = network.corners(t);
    for (int c = 0; c < 3; ++c) {
      const bool wall = is_wall(corners[c]);
      wetted += wall ? walls.surface * throats.wetted_parts[t][c] : 0;
      cut_by += wall;
    }
    const double value = conductance(rule, shape<Rule>(throats, t, wetted), viscosity, smallest_area);
    values[t] = value > 0 ? walls.factor[cut_by] * value : value;
  }
}

double smallest_area(const std::vector<double>& fluid_area) {
  return no_area * Eigen::Map<const Eigen::VectorXd>(fluid_area.data(), std::ssize(fluid_area)).mean();
}

} // namespace

void update(Conductances& conductances, const PoreNetwork& network, const Conductance& rule, const WallRule& walls,
            double viscosity) {
  const auto& throats = network.throats;
  auto& values = conductances.values;
  values.resize(throats.size());
  const double smallest = smallest_area(throats.fluid_area);
  std::visit(
      [&](const auto& law, const auto& wall) {
        fill_interior(law, throats, viscosity, smallest, values.data());
        fill_at_walls(law, wall, network, viscosity, smallest, values.data());
      },
      rule, walls);
  conductances.median = positive_median(values);
  conductances.rounded = 0;
  for (double& value : values)
    if (value < 0) {
      value = -value;
      ++conductances.rounded;
    }
}

Conductances conductances(const PoreNetwork& network, const Conductance& rule, const WallRule& walls,
                          double viscosity) {
  Conductances result;
  update(result, network, rule, walls, viscosity);
  return result;
}

} // namespace pfv
