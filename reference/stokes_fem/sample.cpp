#include "reference/stokes_fem/sample.hpp"

#include "reference/stokes_fem/facet_flux.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace reference::stokes_fem {

namespace {

using pfv::Vec3;

class Sampler {
public:
  Sampler(const FlowMesh& flow, const UnitCase& unit)
      : flow_(flow), packing_(unit.problem.packing), periodic_(periodic_axes(unit.problem.faces)),
        gradient_(imposed_gradient(unit.problem.faces)), search_(flow) {}

  double pressure(const Vec3& point) const {
    Vec3 boxes = Vec3::Zero();
    for (int axis = 0; axis < 3; ++axis)
      if (periodic_[static_cast<std::size_t>(axis)])
        boxes[axis] = std::floor(point[axis] / size()[axis]);
    const Vec3 shift = boxes.cwiseProduct(size());
    const Vec3 inside = point - shift;
    const auto place = in_solid(inside) ? std::nullopt : search_.find(inside);
    if (!place)
      return std::numeric_limits<double>::quiet_NaN();
    return flow_.pressure_at(place->cell, place->weights) + gradient_.dot(point - size() / 2);
  }

  // Of the parts of the facet in every box it reaches into.
  double flux(const Probes::Facet& facet) const {
    std::array<int, 3> from{}, to{};
    for (int axis = 0; axis < 3; ++axis)
      if (periodic_[static_cast<std::size_t>(axis)]) {
        const auto [lowest, highest] = std::ranges::minmax(facet, {}, [&](const Vec3& corner) { return corner[axis]; });
        from[static_cast<std::size_t>(axis)] = static_cast<int>(std::floor(lowest[axis] / size()[axis] - 1e-9));
        to[static_cast<std::size_t>(axis)] = static_cast<int>(std::floor(highest[axis] / size()[axis] + 1e-9));
      }
    double sum = 0;
    for (int i = from[0]; i <= to[0]; ++i)
      for (int j = from[1]; j <= to[1]; ++j)
        for (int k = from[2]; k <= to[2]; ++k) {
          Probes::Facet here = facet;
          for (Vec3& corner : here)
            corner -= Vec3(i, j, k).cwiseProduct(size());
          sum += facet_flux(flow_, search_, here, packing_.box, periodic_);
        }
    return sum;
  }

private:
  Vec3 size() const { return packing_.box.upper; }

  bool in_solid(const Vec3& point) const {
    return std::ranges::any_of(packing_.spheres, [&](const pfv::Sphere& sphere) {
      Vec3 arm = point - sphere.centre;
      for (int axis = 0; axis < 3; ++axis)
        if (periodic_[static_cast<std::size_t>(axis)])
          arm[axis] = std::remainder(arm[axis], size()[axis]);
      return arm.squaredNorm() < sphere.radius * sphere.radius;
    });
  }

  const FlowMesh& flow_;
  const pfv::Packing& packing_;
  pfv::PeriodicAxes periodic_;
  Vec3 gradient_;
  CellSearch search_;
};

} // namespace

void sample(const FlowMesh& flow, const UnitCase& unit, const Probes& probes, Answer& answer) {
  const Sampler sampler(flow, unit);
  const auto in_unit = [&](const Vec3& point) -> Vec3 { return (point - unit.origin) / unit.length; };
  answer.point_pressures.emplace();
  for (const Vec3& point : probes.points)
    answer.point_pressures->push_back(unit.pressure * sampler.pressure(in_unit(point)));
  answer.facet_fluxes.emplace();
  for (Probes::Facet facet : probes.facets) {
    std::ranges::transform(facet, facet.begin(), in_unit);
    answer.facet_fluxes->push_back(unit.flux() * sampler.flux(facet));
  }
}

} // namespace reference::stokes_fem
