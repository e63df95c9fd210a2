#include "reference/openfoam/sample.hpp"

#include "reference/openfoam/case_files.hpp"
#include "reference/openfoam/cell_search.hpp"
#include "reference/openfoam/linear_flow.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace reference::openfoam {

namespace {

constexpr int subdivisions = 32;

class Sampler {
public:
  Sampler(const FoamMesh& mesh, const FlowFields& fields, const pfv::Case& problem)
      : units_(units_of(problem)), packing_(in_units(problem.packing, units_)), search_(mesh),
        flow_(mesh, search_, fields, problem) {}

  double pressure(const pfv::Vec3& at) const {
    const pfv::Vec3 point = at / units_.length;
    const auto cell = in_fluid(point, packing_.spheres) ? search_.cell_of(point) : std::nullopt;
    return cell ? units_.lower_pressure + units_.pressure * flow_.pressure(*cell, point)
                : std::numeric_limits<double>::quiet_NaN();
  }

  double flux(const Probes::Facet& facet) const {
    const auto spheres = spheres_near(facet);
    double sum = 0;
    bool any = false;
    for (std::size_t k = 1; k + 1 < facet.size(); ++k) {
      const pfv::Vec3 origin = facet[0] / units_.length;
      const pfv::Vec3 a = (facet[k] - facet[0]) / units_.length / subdivisions;
      const pfv::Vec3 b = (facet[k + 1] - facet[0]) / units_.length / subdivisions;
      const pfv::Vec3 area = a.cross(b) / 2;
      for (int i = 0; i < subdivisions; ++i)
        for (int j = 0; i + j < subdivisions; ++j)
          // The triangle at this corner of the parallelogram, and the one at the opposite corner.
          for (const double middle : {1.0 / 3, 2.0 / 3}) {
            if (middle > 0.5 && i + j + 1 == subdivisions)
              continue;
            const pfv::Vec3 point = origin + (i + middle) * a + (j + middle) * b;
            if (!in_fluid(point, spheres))
              continue;
            if (const auto cell = search_.cell_of(point)) {
              sum += flow_.velocity(*cell, point).dot(area);
              any = true;
            }
          }
    }
    return any ? units_.flux() * sum : std::numeric_limits<double>::quiet_NaN();
  }

private:
  bool in_fluid(const pfv::Vec3& point, const std::vector<pfv::Sphere>& spheres) const {
    const double slack = 1e-9;
    return ((point - packing_.box.lower).array() >= -slack).all() &&
           ((packing_.box.upper - point).array() >= -slack).all() &&
           std::ranges::none_of(spheres, [&](const pfv::Sphere& sphere) {
             return (point - sphere.centre).squaredNorm() < sphere.radius * sphere.radius;
           });
  }

  std::vector<pfv::Sphere> spheres_near(const Probes::Facet& facet) const {
    pfv::Vec3 middle = pfv::Vec3::Zero();
    for (const pfv::Vec3& corner : facet)
      middle += corner / units_.length / static_cast<double>(facet.size());
    double reach = 0;
    for (const pfv::Vec3& corner : facet)
      reach = std::max(reach, (corner / units_.length - middle).norm());
    std::vector<pfv::Sphere> near;
    for (const pfv::Sphere& sphere : packing_.spheres)
      if ((sphere.centre - middle).norm() < reach + sphere.radius)
        near.push_back(sphere);
    return near;
  }

  Units units_;
  pfv::Packing packing_;
  CellSearch search_;
  LinearFlow flow_;
};

} // namespace

Samples sample(const FoamMesh& mesh, const FlowFields& fields, const pfv::Case& problem, const Probes& probes) {
  const Sampler sampler(mesh, fields, problem);
  Samples samples;
  for (const pfv::Vec3& point : probes.points)
    samples.point_pressures.push_back(sampler.pressure(point));
  for (const Probes::Facet& facet : probes.facets)
    samples.facet_fluxes.push_back(sampler.flux(facet));
  return samples;
}

} // namespace reference::openfoam
