#include "studies/runner/report.hpp"

#include "studies/runner/number_text.hpp"
#include "studies/runner/own_error.hpp"
#include "studies/runner/provenance.hpp"
#include "studies/runner/result_table.hpp"
#include "studies/runner/scaling.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace studies {

namespace {

std::string plan_sentence(const Scope& scope) {
  std::string text =
      scope.quick ? "\nThis is the quick plan: fewer cases and coarser meshes than the study's full plan.\n" : "";
  if (!scope.methods.empty())
    text += fmt::format("\nOnly these methods were asked: {}.\n", fmt::join(scope.methods, ", "));
  return text;
}

std::string value_sentence(const Finding& finding) {
  if (!finding.permeability)
    return "no permeability";
  const Bounded& k = *finding.permeability;
  std::string text = fmt::format("k = {} m²", with_error(k.value, k.error));
  std::size_t answered = 0;
  for (const Row& row : finding.rows)
    answered += row.status == Status::answered ? 1 : 0;
  if (k.error) {
    text += fmt::format(", extrapolated from {} meshes with order {:.2g}", answered, *k.order);
    return finding.bridge_error > 0 ? text + fmt::format(" (bridges: ± {})", percent(finding.bridge_error)) : text;
  }
  return text + (finding.told().convergence_order ? ", from one mesh, so without an error bar" : ", without a mesh");
}

std::string sentence(const StudyCase& one, const Result& result) {
  const Finding& finding = result.finding;
  std::string text = fmt::format("- **{} ({} spheres), {}**: ", one.label, finding.told().spheres, finding.method);
  if (!finding.answered())
    return text + fmt::format("{}: {}.\n", name(finding.told().status), finding.told().message);
  text += value_sentence(finding);
  if (result.comparison.outcome)
    text += fmt::format("; *{}*", name(*result.comparison.outcome));
  text += fmt::format(": {}.", result.comparison.because);
  if (const std::string trouble = finding.trouble(); !trouble.empty())
    text += fmt::format(" Without an answer at {}.", trouble);
  return text + '\n';
}

std::string outcome_sentences(const Study& study, std::span<const Result> list) {
  std::string text;
  for (const StudyCase& one : study.cases)
    for (const Result& result : list)
      if (result.finding.case_id == one.id)
        text += sentence(one, result);
  return text;
}

std::string how_to_read(const Study& study) {
  std::string text = fmt::format(
      "Permeability k: with two or more meshes the Richardson value at mesh size zero. Its error is, with three, "
      "what is left of the drift from the value of the coarser two, if it falls as the values do, and at least {} of "
      "the "
      "distance from the finest mesh to it; with two, {} times that distance, taken with order {} at most. Added to it "
      "are what the noise of the values makes of it, {} of what the flux differs by between sections of the box, and, "
      "where bridges stand for contacts, {} of the share of the fluid that they take. Differences are "
      "relative to the reference, {}; that of the forces is "
      "sqrt(sum |F - F_ref|² / sum |F_ref|²) over the spheres. *Unresolved* is a difference below the reference's own "
      "error. Two answers agree when permeability is within {}, forces within {}, or either within the error bars.\n\n"
      "Dofs, CPU seconds and memory are those of the finest mesh, on one thread; memory is what the method itself adds "
      "to "
      "its process, or its largest outside program. *Mesh* is what making the mesh takes, "
      "counted in full when it came from a cache; *once* is all other work done once per packing (geometry, assembly, "
      "factorisation); *solve* is what one more question to the same packing takes, forces included. Short runs are "
      "repeated and the one with the median CPU seconds is kept.\n",
      least_share, extrapolation_safety, unseen_order, noise_share, bridge_share, study.reference,
      percent(study.tolerance.permeability), percent(study.tolerance.forces));
  if (!study.published_source.empty())
    text += fmt::format("\nPublished figures: {}.\n", study.published_source);
  return text;
}

std::string scaling_section(const Study& study, std::span<const Result> list) {
  const std::vector<TitledTable> tables = scaling_tables(study, list);
  if (tables.empty())
    return "";
  std::string text =
      "\n## How cost grows\n\n"
      "*All* is the whole first iteration, from the spheres to the forces on them; a *repeated step* is one "
      "more of a moving packing that keeps its triangulation. An exponent is the slope between two sizes in "
      "logarithms.\n";
  for (const auto& [title, table] : tables)
    text += fmt::format("\n### {}\n\n{}", title, to_markdown(table));
  return text;
}

} // namespace

std::string report(const Study& study, const Scope& scope, std::span<const Row> rows,
                   const std::filesystem::path& answers) {
  const std::vector<Result> list = results(study, rows, answers);
  std::string text = fmt::format("# {}\n\n{}\n{}", study.title, study.question, plan_sentence(scope));
  if (rows.empty())
    return text + "\nNothing has been run yet.\n";
  text += fmt::format("\n## Results\n\n{}\n{}", to_markdown(result_table(study, list)), how_to_read(study));
  text += scaling_section(study, list);
  text += fmt::format("\n## What the comparisons say\n\n{}", outcome_sentences(study, list));
  text += fmt::format("\n## Runs\n\n{}", to_markdown(run_table(rows)));
  text += fmt::format("\n## Where the numbers come from\n\n{}", to_markdown(provenance(rows)));
  if (const Table notes = method_notes(rows, answers); !notes.rows.empty())
    text += fmt::format("\n{}", to_markdown(notes));
  return text;
}

} // namespace studies
