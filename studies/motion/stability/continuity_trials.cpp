#include "studies/motion/stability/continuity_trials.hpp"

#include "pfv/problem/generate.hpp"
#include "studies/motion/stability/original.hpp"
#include "studies/motion/stability/steady_trials.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace studies {

using namespace pfv;

namespace {

struct Named {
  const char* name;
  Packing exact;
};

/// Simple cubic spheres and the nine keep clear of the walls, as the original wants them; of the others some are
/// centred on walls.
std::vector<Named> lattices() {
  const auto nearly_touching = [](Lattice lattice) {
    return lattice_packing(lattice, 0.99 * touching_solid_fraction(lattice), 3);
  };
  return {{"simple cubic", nearly_touching(Lattice::simple_cubic)},
          {"BCC", nearly_touching(Lattice::bcc)},
          {"FCC", nearly_touching(Lattice::fcc)},
          {"nine spheres", nine_spheres()}};
}

Measured against(const Packing& limit, const Packing& moved, double off) {
  const Case problem = flow_through(moved);
  const SteadyFlow flow = solved(problem);
  const double change = std::abs(*flow.permeability / *solved(flow_through(limit)).permeability - 1);
  Measured result{soundness(problem, flow), remedies(flow), {off, change}};
  result.measures.push_back({"change of k", change});
  result.measures.push_back({"change / (1e-7 + 20 off)", change / allowed_change(off), 0, 1});
  return result;
}

Theirs theirs_at(const Packing& packing, double off) {
  Theirs theirs = original_flow(flow_through(packing));
  if (!theirs.plotted.empty())
    theirs.plotted.insert(theirs.plotted.begin(), off);
  return theirs;
}

/// The sphere nearest to a wall at x, at a gap of this share of its radius, negative when it reaches out.
Packing at_gap(double gap) {
  Packing packing = random_packing({.spheres = 60, .solid_fraction = 0.45, .radius_ratio = 1.35, .seed = 4});
  Sphere& nearest =
      *std::ranges::min_element(packing.spheres, {}, [](const Sphere& s) { return s.centre.x() - s.radius; });
  nearest.centre.x() = (1 + gap) * nearest.radius;
  return packing;
}

} // namespace

std::vector<Trial> jitter_trials() {
  std::vector<Trial> trials;
  for (const auto& [name, exact] : lattices())
    for (const double jitter : {1e-15, 1e-14, 1e-13, 3e-13, 1e-12, 1e-11, 1e-10, 1e-9, 1e-8, 1e-7, 1e-6})
      trials.push_back({"Jittered lattices", fmt::format("{}, {:g} of a cell", name, jitter), jitter == 1e-13,
                        [exact = exact, jitter] { return against(exact, jittered(exact, jitter), jitter); },
                        [exact = exact, jitter] { return theirs_at(jittered(exact, jitter), jitter); }});
  return trials;
}

std::vector<Trial> gap_trials() {
  std::vector<Trial> trials;
  for (const double gap : {1e-3, 1e-6, 1e-9, 1e-12, 1e-15, 0.0, -1e-12, -1e-6, -1e-3})
    trials.push_back({"A narrow gap at a wall", fmt::format("gap of {:g} of the radius", gap),
                      std::abs(gap) == 1e-9 || gap == -1e-6,
                      [=] { return against(at_gap(0), at_gap(gap), std::abs(gap)); },
                      [=] { return original_flow(flow_through(at_gap(gap))); }});
  return trials;
}

} // namespace studies
