#include "reference/correlations/correlation_method.hpp"

#include "pfv/problem/error.hpp"
#include "reference/correlations/drag.hpp"
#include "reference/correlations/sizes.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace reference {

namespace {

/// Kozeny constants of Wyllie & Gregory 1955: the middle of what they found, and half of its width.
constexpr double wyllie_gregory_constant = 4.8, wyllie_gregory_spread = 0.3;

struct Correlation {
  const char* name;
  const char* description;
  double least, most;     // solid fraction
  const char* range_from; // who says so
  double (*permeability)(double solid_fraction, double diameter, std::span<const pfv::Sphere> spheres); // m^2
  double relative_error = 0; // of k, where the source gives a spread
};

using Spheres = std::span<const pfv::Sphere>;

const Correlation correlations[] = {
    {"carman_kozeny", "correlation: Kozeny constant 5, 180 in all (Carman 1937)", 0.11, 0.74,
     "the beds that Carman 1937 compared it with, porosity 0.26 to 0.89",
     [](double phi, double d, Spheres) { return kozeny_permeability(phi, d, 5); }},
    {"ergun", "correlation: the viscous term of Ergun 1952, 150", 0.08, 0.64,
     "the beds that Macdonald et al. 1979 tried it on, porosity 0.36 to 0.92",
     [](double phi, double d, Spheres) { return kozeny_permeability(phi, d, 150.0 / 36); }},
    {"wyllie_gregory", "correlation: Kozeny constants 4.5 to 5.1 of loose spheres (Wyllie & Gregory 1955), 4.8 taken",
     0.5, 0.7, "porosity 0.3 to 0.5, our choice: beds of loose spheres, as they measured",
     [](double phi, double d, Spheres) { return kozeny_permeability(phi, d, wyllie_gregory_constant); },
     wyllie_gregory_spread / wyllie_gregory_constant},
    {"beetstra", "correlation of lattice Boltzmann, with its factor for unequal spheres (Beetstra et al. 2007)", 0.1,
     0.6, "the simulations of Beetstra et al. 2007",
     [](double phi, double d, Spheres spheres) {
       return permeability_of_drag(phi, d, beetstra_drag(phi) * beetstra_packing_factor(phi, spheres));
     }},
    {"tenneti", "correlation of immersed-boundary simulations (Tenneti et al. 2011)", 0.1, 0.5,
     "the simulations of Tenneti et al. 2011",
     [](double phi, double d, Spheres) { return permeability_of_drag(phi, d, tenneti_drag(phi)); }}};

constexpr double tolerance = 1e-9; // of a radius, and of a solid fraction at the end of a range

bool cut_by_a_wall(const pfv::Case& problem) {
  const auto periodic = periodic_axes(problem.faces);
  const pfv::Box& box = problem.packing.box;
  return std::ranges::any_of(problem.packing.spheres, [&](const pfv::Sphere& sphere) {
    const double inside = (1 - tolerance) * sphere.radius;
    for (int axis = 0; axis < 3; ++axis)
      if (!periodic[axis] &&
          (sphere.centre[axis] - box.lower[axis] < inside || box.upper[axis] - sphere.centre[axis] < inside))
        return true;
    return false;
  });
}

class CorrelationMethod : public Method {
public:
  explicit CorrelationMethod(const Correlation& of) : of_(of) {}

  std::string name() const override { return of_.name; }
  std::string description() const override { return of_.description; }
  std::vector<std::string> built_from() const override { return {"pfv/problem", "reference/correlations"}; }

  std::optional<std::string> not_covered(const pfv::Case& problem) const override {
    const auto setup = pfv::permeability_setup(problem);
    if (!setup || !setup->pressure_drop)
      return "needs flow along one axis under a given pressure drop or mean gradient and nothing across it";
    if (problem.packing.spheres.empty())
      return "there are no spheres";
    if (cut_by_a_wall(problem))
      return "a sphere is cut by a wall: the solid fraction is not that of whole spheres";
    const double phi = pfv::solid_fraction(problem.packing);
    if (phi < of_.least * (1 - tolerance) || phi > of_.most * (1 + tolerance))
      return fmt::format("solid fraction {:.4g} is outside of {} to {}: {}", phi, of_.least, of_.most, of_.range_from);
    return std::nullopt;
  }
  Estimate estimate(const pfv::Case&, const Request&) const override { return {0, 1e-3, 1e6}; }

  Answer solve(const pfv::Case& problem, const Request&, pfv::Clock& clock) const override {
    if (const auto reason = not_covered(problem))
      throw pfv::SolveError(fmt::format("{} does not cover this case: {}", of_.name, *reason));
    Answer answer;
    answer.method = of_.name;
    {
      const auto timing = clock.stage("evaluate");
      const auto setup = *pfv::permeability_setup(problem);
      const auto& spheres = problem.packing.spheres;
      const double phi = pfv::solid_fraction(problem.packing), diameter = sauter_diameter(spheres);
      const double k = of_.permeability(phi, diameter, spheres);
      const double flux = k * setup.area * *setup.pressure_drop / (problem.fluid.viscosity * setup.length);
      const auto lower = static_cast<std::size_t>(2 * pfv::index(setup.axis));
      answer.permeability = k;
      answer.face_flux[lower] = flux;
      answer.face_flux[lower + 1] = -flux;
      answer.porosity = 1 - phi;
      answer.counts = {{sauter_diameter_count, diameter}, {"drag_coefficient", diameter * diameter / (18 * phi * k)}};
      if (of_.relative_error > 0)
        answer.counts["relative_error"] = of_.relative_error;
      answer.notes = {{"range", fmt::format("solid fraction {} to {}: {}", of_.least, of_.most, of_.range_from)}};
      if (periodic_axes(problem.faces) != pfv::PeriodicAxes{true, true, true})
        answer.notes["bulk"] = "the correlation is that of a bulk, this box has walls";
    }
    answer.stages = clock.stages();
    return answer;
  }

private:
  const Correlation& of_;
};

} // namespace

std::vector<std::unique_ptr<Method>> make_correlations() {
  std::vector<std::unique_ptr<Method>> list;
  for (const Correlation& one : correlations)
    list.push_back(std::make_unique<CorrelationMethod>(one));
  return list;
}

} // namespace reference
