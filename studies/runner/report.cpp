#include "studies/runner/report.hpp"

#include "studies/places/places.hpp"
#include "studies/runner/accuracy.hpp"
#include "studies/runner/curve.hpp"
#include "studies/runner/number_text.hpp"
#include "studies/runner/own_error.hpp"
#include "studies/runner/packing_picture.hpp"
#include "studies/runner/provenance.hpp"
#include "studies/runner/report_plots.hpp"
#include "studies/runner/result_table.hpp"
#include "studies/runner/scaling.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <map>

namespace studies {

namespace {

void add_plan(const Scope& scope, Document& page) {
  if (scope.quick)
    page.add(Paragraph{"This is the quick plan: fewer cases and coarser meshes than the study's full plan."});
  if (!scope.methods.empty())
    page.add(Paragraph{fmt::format("Only these methods were asked: {}.", fmt::join(scope.methods, ", "))});
}

/// "65 answers agree with the reference stokes_fem, 28 differ from it, 14 not covered."
std::string outcome(const Study& study, std::span<const Result> list) {
  std::size_t agree = 0, differ = 0, without_reference = 0;
  std::map<std::string_view, std::size_t> unanswered;
  for (const Result& result : list) {
    if (!result.finding.answered())
      ++unanswered[name(result.finding.told().status)];
    else if (result.comparison.outcome == Outcome::agrees)
      ++agree;
    else if (result.comparison.outcome == Outcome::differs)
      ++differ;
    else if (result.comparison.outcome)
      ++without_reference;
  }
  std::string text =
      fmt::format("{} {} with the reference {}, {} {} from it", agree, agree == 1 ? "answer agrees" : "answers agree",
                  study.reference, differ, differ == 1 ? "differs" : "differ");
  if (without_reference > 0)
    text += fmt::format(", {} without an answer of it to compare with", without_reference);
  for (const auto& [status, times] : unanswered)
    text += fmt::format(", {} {}", times, status);
  return text + '.';
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
  std::string text = fmt::format("**{} ({} spheres), {}**: ", one.label, finding.told().spheres, finding.method);
  if (!finding.answered())
    return text + fmt::format("{}: {}.", name(finding.told().status), finding.told().message);
  text += value_sentence(finding);
  if (result.comparison.outcome)
    text += fmt::format("; *{}*", name(*result.comparison.outcome));
  text += fmt::format(": {}.", result.comparison.because);
  if (const std::string trouble = finding.trouble(); !trouble.empty())
    text += fmt::format(" Without an answer at {}.", trouble);
  return text;
}

List outcome_sentences(const Study& study, std::span<const Result> list) {
  List sentences;
  for (const StudyCase& one : study.cases)
    for (const Result& result : list)
      if (result.finding.case_id == one.id)
        sentences.items.push_back(sentence(one, result));
  return sentences;
}

void add_how_to_read(const Study& study, Document& page) {
  page.add(Paragraph{fmt::format(
      "Permeability k: with two or more meshes the Richardson value at mesh size zero. Its error is, with three, "
      "what is left of the drift from the value of the coarser two, if it falls as the values do, and at least {} of "
      "the "
      "distance from the finest mesh to it; with two, {} times that distance, taken with order {} at most. Added to it "
      "are what the noise of the values makes of it, {} of what the flux differs by between sections of the box, and, "
      "where bridges stand for contacts, {} of the share of the fluid that they take. Differences are "
      "relative to the reference, {}; that of the forces is "
      "sqrt(sum |F - F_ref|² / sum |F_ref|²) over the spheres. *Unresolved* is a difference below the reference's own "
      "error. Two answers agree when permeability is within {}, forces within {}, or either within the error bars.",
      least_share, extrapolation_safety, unseen_order, noise_share, bridge_share, study.reference,
      percent(study.tolerance.permeability), percent(study.tolerance.forces))});
  page.add(Paragraph{
      "Dofs, CPU seconds and memory are those of the finest mesh, on one thread; memory is what the method itself adds "
      "to "
      "its process, or its largest outside program. *Mesh* is what making the mesh takes, "
      "counted in full when it came from a cache; *once* is all other work done once per packing (geometry, assembly, "
      "factorisation); *solve* is what one more question to the same packing takes, forces included. Short runs are "
      "repeated and the one with the median CPU seconds is kept."});
  if (!study.published_source.empty())
    page.add(Paragraph{fmt::format("Published figures: {}.", study.published_source)});
}

void add_scaling(const Study& study, std::span<const Result> list, Document& page) {
  const std::vector<TitledTable> tables = scaling_tables(study, list);
  if (tables.empty())
    return;
  page.add(Heading{"How cost grows"});
  page.add(
      Paragraph{"*All* is the whole first iteration, from the spheres to the forces on them; a *repeated step* is one "
                "more of a moving packing that keeps its triangulation. An exponent is the slope between two sizes in "
                "logarithms."});
  for (const Plot& plot : scaling_plots(study, list))
    page.add(plot);
  for (const auto& [title, table] : tables) {
    page.add(Heading{title, 3});
    page.add(table);
  }
}

void add_curves(const Study& study, std::span<const Result> list, Document& page) {
  const std::vector<TitledTable> tables = curve_tables(study, list);
  if (tables.empty())
    return;
  page.add(Heading{"Permeability against porosity"});
  page.add(Paragraph{
      "Means over cases that differ by their seed only. d is the Sauter diameter, sum d³ / sum d². Bars: half of "
      "what these cases span, with the mean error of the answers added. A correlation is missing where it "
      "says that it does not hold."});
  for (const std::string& curve : curve_names(study))
    for (const Plot& plot : curve_plots(study, list, curve))
      page.add(plot);
  for (const auto& [title, table] : tables) {
    page.add(Heading{title, 3});
    page.add(table);
  }
}

void add_accuracy(const Study& study, std::span<const Result> list, Document& page) {
  Table table = accuracy_table(study, list);
  if (table.rows.empty())
    return;
  page.add(Heading{"CPU seconds to be within an error"});
  page.add(Paragraph{fmt::format(
      "Of the coarsest mesh, meshing included, whose permeability, and that of all finer ones, is so near to the "
      "extrapolated one of {0} that its distance and the error of {0} are within the level together: the median over "
      "the cases, and in how many of those asked if not in all. *Extrapolated*: from all its meshes, which costs them "
      "all. A level that is less than twice the error of {0} tells nothing.",
      study.reference)});
  page.add(std::move(table));
  Plot plot = error_plot(study, list);
  plot.width = 820;
  plot.height = 520;
  if (!plot.empty())
    page.add(std::move(plot));
}

constexpr std::size_t long_list = 40; // more lines than this are folded

} // namespace

Document report(const Study& study, const Scope& scope, std::span<const Row> rows,
                const std::filesystem::path& answers) {
  const std::vector<Result> list = results(study, rows, answers);
  Document page{study.title, {}};
  page.add(Paragraph{study.question});
  add_plan(scope, page);
  if (rows.empty()) {
    page.add(Paragraph{"Nothing has been run yet."});
    return page;
  }
  page.add(Paragraph{std::string(outcome_lead) + outcome(study, list)});
  add_curves(study, list, page);
  add_accuracy(study, list, page);
  page.add(Heading{"Results"});
  if (!study.curve) // a line for each case would be longer than the curves
    for (const Plot& plot : permeability_plots(study, list))
      page.add(plot);
  if (Plot plot = error_plot(study, list); !study.accuracy && !plot.empty())
    page.add(plot);
  for (const Figure& figure : packing_figures(study, list))
    page.add(figure);
  if (Table table = result_table(study, list); study.curve && table.rows.size() > long_list)
    page.add(Details{Heading{"All cases", 3}, {{std::move(table)}}});
  else
    page.add(std::move(table));
  add_how_to_read(study, page);
  add_scaling(study, list, page);
  add_places(study, list, page);
  const Heading says{"What the comparisons say"};
  const List sentences = outcome_sentences(study, list);
  if (sentences.items.size() > long_list)
    page.add(Details{says, {{sentences}}});
  else {
    page.add(says);
    page.add(sentences);
  }
  page.add(Details{Heading{"Runs"}, {{run_table(rows)}}});
  page.add(Heading{"Where the numbers come from"});
  page.add(provenance(rows));
  if (const Table notes = method_notes(rows, answers); !notes.rows.empty())
    page.add(notes);
  return page;
}

} // namespace studies
