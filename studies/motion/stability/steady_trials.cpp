#include "studies/motion/stability/steady_trials.hpp"

#include "studies/motion/stability/hard_packings.hpp"
#include "studies/motion/stability/original.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace studies {

using namespace pfv;

namespace {

SteadyFlow solved_by(const Case& problem, const SolverChoice& solver) {
  Clock clock;
  return solve_steady_flow(problem, {.solver = solver}, clock);
}

/// Of two that may both be zero.
double relative_difference(double a, double b) {
  return a == b ? 0 : std::abs(a - b) / std::max(std::abs(a), std::abs(b));
}

/// What is left when spheres and faces are summed, over the drop times the area.
double unbalanced_force(const Case& problem, const SteadyFlow& flow) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t k = 0; k < flow.forces.pressure.size(); ++k)
    sum += flow.forces.of_flow(k);
  for (const Vec3& force : flow.forces.on_face)
    sum += force;
  const auto setup = permeability_setup(problem).value();
  return sum.norm() / (setup.area * *setup.pressure_drop);
}

Measured measured(const Packing& packing, double most_permeable) {
  const Case problem = flow_through(packing);
  // A matrix that is not positive definite has no Cholesky factor: the case then fails.
  const SteadyFlow flow = solved(problem), other = solved_by(problem, Multigrid{});
  Measured result{soundness(problem, flow), remedies(flow)};
  result.measures.front().most = most_permeable;
  result.measures.push_back(
      {"k by multigrid and by Cholesky differ", relative_difference(*flow.permeability, *other.permeability), 0, 1e-6});
  return result;
}

} // namespace

Case flow_through(const Packing& packing) {
  Case problem;
  problem.packing = packing;
  problem.faces = flow_along(Axis::z);
  validate(problem);
  return problem;
}

SteadyFlow solved(const Case& problem) {
  return solved_by(problem, Cholmod{});
}

std::vector<Measure> soundness(const Case& problem, const SteadyFlow& flow) {
  const auto [lowest, highest] = std::ranges::minmax(flow.pressure);
  const double length = permeability_setup(problem).value().length;
  return {{"k / length²", flow.permeability.value() / (length * length), 0, 1},
          {"flux imbalance", flow.imbalance(), 0, 1e-8},
          {"lowest pressure / drop", lowest, -1e-9},
          {"highest - 1", highest - 1, -Measure::none, 1e-9},
          {"sum of all forces / load", unbalanced_force(problem, flow), 0, 1e-9}};
}

std::string remedies(const SteadyFlow& flow) {
  std::string text;
  const auto add = [&](std::size_t count, const char* what) {
    if (count > 0)
      text += fmt::format("{}{} {}", text.empty() ? "" : ", ", count, what);
  };
  add(flow.system.contracted_throats, "contracted");
  add(flow.network.closed_throats, "closed");
  add(flow.system.rounded_throats, "rounded");
  add(flow.system.isolated_pores, "isolated");
  add(flow.clamped_pores, "clamped");
  add(flow.network.flat_pores, "flat");
  add(flow.network.inverted_throats, "inverted");
  add(flow.network.hidden_spheres.size(), "hidden");
  return text;
}

std::vector<Trial> steady_trials() {
  std::vector<Trial> trials;
  for (const HardPacking& one : hard_packings())
    trials.push_back({"Packings at rest", fmt::format("{}, {} in all", one.name, one.packing.spheres.size()), one.quick,
                      [packing = one.packing, most = one.most_permeable] { return measured(packing, most); },
                      [packing = one.packing] { return original_flow(flow_through(packing)); }});
  return trials;
}

} // namespace studies
