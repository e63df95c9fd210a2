#include "studies/motion/stability/stability.hpp"
#include "studies/motion/stability/stability_figure.hpp"
#include "studies/motion/stability/stability_tables.hpp"

#include "reference/yade/program.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace studies {
namespace {

constexpr const char* how_to_read =
    R"(Every case runs in a process of its own: one that crashes, or does not end, is a row with its last words. Titles of columns
carry the bound that a value is held by; what is set in bold is outside of it. The matrix of every packing at rest is factorised by
Cholesky, so that one which is not positive definite fails its row. Remedies are counted: throats *contracted* (their two pores
nearly coincide), *closed* (spheres cover them), *rounded* (taken for round tubes), pores
*isolated* (no way to a known pressure), *clamped* (pressures of round-off) or *flat*, throats *inverted*, spheres *hidden* by others.)";

/// What follows about a group's own measures.
std::string about(const std::string& group) {
  if (group == "Jittered lattices" || group == "A narrow gap at a wall")
    return "*Off* is the jitter over the cell, or the gap over the radius; k is held against that of the exact "
           "lattice, "
           "of the sphere that touches.";
  if (group == "To be refused")
    return "`pfv permeability` is run on each.";
  if (group == "A flip of the triangulation")
    return "A sphere moves across the place where its neighbours change partners, found to 1e-13 of its radius. A jump "
           "is "
           "the largest change of the force on a sphere, over the rms force. Of the original, the spheres nearest to "
           "the "
           "corners of the box are left out, as its forces on four of them are wrong.";
  if (group == "Renewal of the pores")
    return "Grains part along given velocities until pores are measured anew in place (0.01 of the mean radius) or "
           "triangulated anew (0.05); forces on the old pores and on the new ones, all grains in the same places.";
  if (group == "Steady motion")
    return "Velocities of 150 spheres that are nearly the same for 400 steps: forces of a fluid that starts every step "
           "from "
           "the last pressures and their changes, to a tolerance of 1e-4, against those of one without a past.";
  if (group == "Explicit steps below the limit")
    return "150 grains in a fluid of 300 Pa s, 3000 steps; the limit is that of contacts and fluid together. The "
           "original "
           "runs its own oedometer on the same grains, as many steps of the shares told of the fluid's limit, after "
           "2000 "
           "dry ones. Its own limit, which it does not tell, is another one, as its throats at walls conduct less.";
  if (group == "Explicit steps above the limit")
    return "The same; the limit is that of the fluid alone. A run must leave stability within 20 000 steps and say so.";
  if (group == "Semi-implicit steps")
    return "Settlement after 10 000 times the explicit limit.";
  if (group == "Resistance to motion")
    return "The matrix of forces against velocities of 60 spheres. The fluid only takes energy when it is symmetric "
           "and "
           "no eigenvalue is negative. Of the original, spheres nearest to the corners are left out.";
  if (group == "Energy of a coupled run")
    return "4000 steps of 150 grains under a piston, at a tenth of the step that would be taken.";
  return {};
}

std::vector<std::string> groups_of(const std::vector<TrialRow>& rows) {
  std::vector<std::string> groups;
  for (const TrialRow& row : rows)
    if (std::ranges::find(groups, row.group) == groups.end())
      groups.push_back(row.group);
  return groups;
}

std::vector<TrialRow> of_group(const std::vector<TrialRow>& rows, const std::string& group) {
  std::vector<TrialRow> result;
  std::ranges::copy_if(rows, std::back_inserter(result), [&](const TrialRow& row) { return row.group == group; });
  return result;
}

} // namespace

ExperimentReport stability_report(const std::vector<TrialRow>& rows) {
  std::vector<Expectation> expectations;
  for (const std::string& group : groups_of(rows))
    std::ranges::move(expectations_of(of_group(rows, group)), std::back_inserter(expectations));
  ExperimentReport report;
  report.holds = all_hold(expectations);
  Document& page = report.page = page_of(stability_experiment, expectations);
  page.add(
      Figure{"Left: change of k of a lattice by a jitter, against the exact lattice; of the original, against its "
             "own k at the largest jitter. Values below 1e-16 are drawn there. Right: how the resistance to motion "
             "fails to be symmetric, what negative eigenvalues it has, and what the energy balance misses.",
             "figure.svg"});
  page.add(Paragraph{how_to_read});
  page.add(Paragraph{
      reference::yade::missing_program()
          ? "The original implementation, FlowEngine of YADE, is not installed here (Debian package yade), so that no "
            "case says what it does."
          : fmt::format(
                "The original implementation, FlowEngine of {}, is asked the same, each time in a process of its "
                "own. Its rule at walls is another one, so k is not to be compared: what counts is whether there "
                "is an answer, and whether that is finite, balanced and steady.",
                reference::yade::program_version())});
  for (const std::string& group : groups_of(rows)) {
    page.add(Heading{group});
    if (const std::string text = about(group); !text.empty())
      page.add(Paragraph{text});
    page.add(trial_table(of_group(rows, group)));
  }
  double cpu_seconds = 0;
  for (const TrialRow& row : rows)
    cpu_seconds += row.cpu_seconds;
  page.add(Paragraph{fmt::format("Ours took {:.0f} CPU seconds in all.", cpu_seconds)});
  page.add(Heading{"Where the numbers come from"});
  page.add(build_table());
  report.files = {{"measures.csv", measures_csv(rows)},
                  {"outcomes.csv", outcomes_csv(rows)},
                  {"jitter.csv", jitter_csv(rows)},
                  {"passivity.csv", passivity_csv(rows)},
                  {"figure.gp", figure_script(940, 470, 2, stability_figure(rows))}};
  report.summary = to_plain(expectation_table(expectations));
  return report;
}

} // namespace studies
