#include "reference/yade/limits.hpp"

#include "reference/walls_and_pressures.hpp"

#include <cmath>
#include <fmt/format.h>

namespace reference::yade {

namespace {

constexpr double most_face_cells = 1e4;

// Cells that touch a face of a random packing: measured 1.6 for each sphere of a layer of the mean spacing.
double face_cells(const pfv::Packing& packing, double area) {
  const double number_density = static_cast<double>(packing.spheres.size()) / packing.box.volume();
  return 1.6 * area * std::pow(number_density, 2.0 / 3);
}

std::optional<std::size_t> reaching_out(const pfv::Packing& packing) {
  for (std::size_t k = 0; k < packing.spheres.size(); ++k) {
    const auto& [centre, radius] = packing.spheres[k];
    const double room = std::min((centre - packing.box.lower).minCoeff(), (packing.box.upper - centre).minCoeff());
    if (room < 0.99 * radius)
      return k;
  }
  return std::nullopt;
}

} // namespace

std::optional<std::string> beyond_limits(const pfv::Case& problem) {
  if (const auto reason = beyond_walls_and_pressures(problem))
    return reason;
  const auto setup = pfv::permeability_setup(problem);
  if (!setup || !setup->pressure_drop)
    return "needs different pressures on two opposite faces and slip walls on the other four";
  const auto& spheres = problem.packing.spheres;
  if (spheres.size() < 3)
    return fmt::format("{} spheres; FlowEngine crashes on fewer than 3", spheres.size());
  if (const auto k = reaching_out(problem.packing))
    return fmt::format("sphere {} reaches out of the box; FlowEngine takes only spheres inside", *k);
  if (const double cells = face_cells(problem.packing, setup->area); cells > most_face_cells)
    return fmt::format("about {:.0f} cells on a pressure face; FlowEngine corrupts its memory above {:.0f}", cells,
                       most_face_cells);
  return std::nullopt;
}

Estimate expected_cost(const pfv::Case& problem) {
  const auto spheres = static_cast<double>(problem.packing.spheres.size());
  return {6.1 * spheres, 2 + 1.2e-4 * spheres + 1.2e-6 * std::pow(spheres, 1.5),
          2.6e8 + 1.5e4 * spheres + 40 * std::pow(spheres, 1.5)};
}

} // namespace reference::yade
