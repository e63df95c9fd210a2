#include "pfv/flow/conductance.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pfv {
namespace {

constexpr double no_area = 1e-12; // of the mean fluid area

double conductance(const HydraulicRadius& rule, const PoreNetwork::Throats& throats, std::size_t t, double viscosity) {
  const double radius = throats.void_volume[t] / throats.sphere_surface(t);
  return rule.alpha * throats.fluid_area[t] * radius * radius / (viscosity * throats.length[t]);
}

double wall_factor(const MirrorWalls&, const std::array<Vertex, 3>&) {
  return 1;
}

double wall_factor(const OriginalWalls&, const std::array<Vertex, 3>& vertices) {
  return std::pow(2, -0.5 * static_cast<double>(std::ranges::count_if(vertices, is_wall)));
}

double median_of(std::vector<double> values) {
  if (values.empty())
    return 0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
}

} // namespace

Conductances conductances(const PoreNetwork& network, const Conductance& rule, const WallRule& walls,
                          double viscosity) {
  const auto& throats = network.throats;
  double total_area = 0;
  for (const double area : throats.fluid_area)
    total_area += std::abs(area);
  const double smallest_area = no_area * total_area / static_cast<double>(throats.size());

  Conductances result;
  result.values.assign(throats.size(), 0);
  std::vector<double> open_values;
  std::vector<std::size_t> closed;
  std::visit(
      [&](const auto& law, const auto& wall) {
        for (std::size_t t = 0; t < throats.size(); ++t) {
          if (std::abs(throats.fluid_area[t]) <= smallest_area && throats.sphere_surface(t) <= smallest_area)
            continue;
          const bool open = throats.fluid_area[t] > 0 && throats.void_volume[t] > 0 && throats.sphere_surface(t) > 0;
          if (throats.length[t] <= 0) {
            result.values[t] = std::numeric_limits<double>::infinity();
          } else if (open) {
            result.values[t] = conductance(law, throats, t, viscosity) * wall_factor(wall, throats.vertices[t]);
            open_values.push_back(result.values[t]);
          } else {
            closed.push_back(t);
          }
        }
      },
      rule, walls);
  result.median = median_of(std::move(open_values));
  for (const std::size_t t : closed)
    result.values[t] = Conductances::floor * result.median;
  result.raised = closed.size();
  return result;
}

} // namespace pfv
