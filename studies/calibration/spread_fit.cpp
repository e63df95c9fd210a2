#include "studies/calibration/spread_fit.hpp"

#include "pfv/flow/steady_flow.hpp"
#include "pfv/problem/error.hpp"
#include "reference/cut_spheres.hpp"

#include <fmt/format.h>

#include <cmath>

namespace studies {

namespace {

/// |F - F_known|^2 / |F_known|^2 = off - 2 share slope + share^2 curve, over all spheres of one packing.
struct Parabola {
  double off = 0, slope = 0, curve = 0;

  double rms(double share) const { return std::sqrt(std::max(off + share * (share * curve - 2 * slope), 0.0)); }
};

/// N by sphere, as an answer of a method has them.
std::vector<pfv::Vec3> forces(const pfv::Case& problem, pfv::Calibrated rule, double share) {
  rule.shear_spread = share;
  pfv::Clock clock;
  pfv::FluidForces found = solve_steady_flow(problem, {.conductance = rule, .solver = pfv::Cholmod{}}, clock).forces;
  std::vector<pfv::Vec3> on_spheres;
  for (std::size_t k = 0; k < found.pressure.size(); ++k)
    on_spheres.push_back(found.of_flow(k));
  reference::give_normal_parts_to_slip_walls(problem, on_spheres, found.on_face);
  return on_spheres;
}

Parabola parabola(const KnownFlow& known, const pfv::Calibrated& rule) {
  const auto by_throat = forces(known.problem, rule, 0), spread = forces(known.problem, rule, 1);
  Parabola result;
  double whole = 0;
  for (std::size_t k = 0; k < known.force.size(); ++k) {
    const pfv::Vec3 missing = known.force[k] - by_throat[k], change = spread[k] - by_throat[k];
    result.off += missing.squaredNorm();
    result.slope += missing.dot(change);
    result.curve += change.squaredNorm();
    whole += known.force[k].squaredNorm();
  }
  return {result.off / whole, result.slope / whole, result.curve / whole};
}

} // namespace

SpreadFit fit_shear_spread(std::span<const KnownFlow> packings, const pfv::Calibrated& rule) {
  if (packings.size() < 2)
    throw pfv::InputError(fmt::format("{} packings: a fit of one share, with one left out, needs 2", packings.size()));
  std::vector<Parabola> of;
  double slope = 0, curve = 0;
  for (const auto& known : packings) {
    of.push_back(parabola(known, rule));
    slope += of.back().slope;
    curve += of.back().curve;
  }
  SpreadFit fit{.share = slope / curve, .standard_error = 0, .by_throat = {}, .fitted = {}, .left_out = {}};
  double scatter = 0; // packings are independent, spheres of one are not
  for (const Parabola& one : of) {
    scatter += std::pow(one.slope - fit.share * one.curve, 2);
    fit.by_throat.push_back(one.rms(0));
    fit.fitted.push_back(one.rms(fit.share));
    fit.left_out.push_back(one.rms((slope - one.slope) / (curve - one.curve)));
  }
  fit.standard_error = std::sqrt(scatter) / curve;
  return fit;
}

} // namespace studies
