#include "studies/motion/stability/original.hpp"

#include "pfv/problem/error.hpp"
#include "reference/yade/program.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace studies {

using namespace reference;

namespace {

constexpr double balanced = 1e-6; // of the flux

double permeability(const pfv::Case& problem, double flux) {
  const auto setup = pfv::permeability_setup(problem).value();
  return problem.fluid.viscosity * flux * setup.length / (setup.area * *setup.pressure_drop);
}

/// What spheres carry along the flow, over the drop times the area: 1 between walls without friction.
double carried(const pfv::Case& problem, const yade::Reply& reply) {
  const auto setup = pfv::permeability_setup(problem).value();
  double sum = 0;
  for (const pfv::Vec3& force : reply.forces)
    sum -= force[pfv::index(setup.axis)];
  return sum / (setup.area * *setup.pressure_drop);
}

} // namespace

std::string in_words(const std::string& failure) {
  const std::string killed = "killed by ", stopped = "stopped after ", lead = "yade: ";
  std::string what = failure.starts_with(lead) ? failure.substr(lead.size()) : failure;
  if (what.find("not a finite number") != what.npos)
    return "nan, exit code 0";
  if (what.starts_with("yade left no reply"))
    return "no answer, exit code 0";
  if (what.starts_with(killed) || what.starts_with(stopped)) {
    what = what.substr(0, what.find(';'));
    return what.starts_with(killed) ? "crashed with " + what.substr(killed.size())
                                    : "no answer in " + what.substr(stopped.size());
  }
  // Of a message of several lines the last says what went wrong.
  const auto words = what.find("; its last words: "), last = what.rfind(" | ");
  return words == what.npos || last == what.npos ? what : what.substr(0, words) + ": " + what.substr(last + 3);
}

std::vector<bool> away_from_corners(const pfv::Packing& packing) {
  std::vector<bool> away(packing.spheres.size(), true);
  for (int corner = 0; corner < 8; ++corner) {
    const pfv::Vec3 share(corner & 1, corner >> 1 & 1, corner >> 2);
    const pfv::Vec3 at = packing.box.lower + share.cwiseProduct(packing.box.size());
    const auto nearest = std::ranges::min_element(
        packing.spheres, {}, [&](const pfv::Sphere& sphere) { return (sphere.centre - at).norm() - sphere.radius; });
    away[static_cast<std::size_t>(nearest - packing.spheres.begin())] = false;
  }
  return away;
}

OriginalAnswer ask_original(const pfv::Case& problem) {
  if (yade::missing_program())
    return {{}, not_installed};
  try {
    return {yade::run_flow_engine(problem, {}, original_wall_limit), {}};
  } catch (const pfv::SolveError& error) {
    return {{}, in_words(error.what())};
  }
}

Theirs original_flow(const pfv::Case& problem) {
  const OriginalAnswer answer = ask_original(problem);
  if (!answer.reply)
    return {answer.why_not};
  const double k = permeability(problem, answer.reply->flux_out);
  const double imbalance = std::abs(answer.reply->flux_in / answer.reply->flux_out - 1);
  if (!(imbalance < balanced))
    return {fmt::format("fluxes do not balance: {:.3g} in, {:.3g} out", answer.reply->flux_in, answer.reply->flux_out)};
  const double load = carried(problem, *answer.reply);
  if (k < 0)
    return {fmt::format("negative: k = {:.3g}", k)};
  return {fmt::format("k = {:.3g}, spheres carry {:.2f} of the load", k, load), {k}};
}

} // namespace studies
