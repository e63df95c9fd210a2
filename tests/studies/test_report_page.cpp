#include "studies/document/html.hpp"
#include "studies/document/markdown.hpp"
#include "studies/runner/files.hpp"
#include "studies/runner/index_page.hpp"
#include "studies/runner/packing_picture.hpp"
#include "studies/runner/report.hpp"
#include "studies/runner/report_plots.hpp"
#include "studies/runner/write_pages.hpp"

#include "pfv/problem/text.hpp"
#include "tests/studies/example_row.hpp"
#include "tests/studies/study_text.hpp"
#include "tests/studies/temporary_folder.hpp"
#include "tests/studies/times.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <regex>
#include <set>

namespace studies {
namespace {

Study example_study() {
  const TemporaryFolder folder;
  Study study = read_study(folder.write("study.toml", study_text));
  study.folder.clear(); // it is gone
  study.methods = {{"pore_volumes", {1}, {}}, {"exact", {2, 1}, {}}};
  return study;
}

Row row_of(const std::string& method, const std::string& case_id, double mesh_size, double permeability) {
  Row row = example_row(method, mesh_size);
  row.key += case_id;
  row.case_id = case_id;
  row.permeability = permeability;
  row.spheres = case_id == "one" ? 2 : 3;
  if (method == "pore_volumes")
    row.convergence_order.reset();
  return row;
}

// The reference, exact, extrapolates to 1 and to 2 with an error of a few percent; the other is 30 % and 1 % high.
std::vector<Row> example_rows() {
  return {row_of("pore_volumes", "one", 1, 1.3),  row_of("exact", "one", 2, 1.16), row_of("exact", "one", 1, 1.04),
          row_of("pore_volumes", "two", 1, 2.02), row_of("exact", "two", 2, 2.16), row_of("exact", "two", 1, 2.04)};
}

std::vector<Result> example_results() {
  return results(example_study(), example_rows(), "/nowhere");
}

TEST(ReportPage, HasEveryRowOfEveryTable) {
  const Document page = report(example_study(), {}, example_rows(), "/nowhere");
  const std::string html = to_html(page), markdown = to_markdown(page);
  // A line of Markdown for titles, one for the rule, one for each row.
  const std::size_t lines = times(markdown, "\n|"), tables = times(markdown, "\n| --- |");
  EXPECT_EQ(times(html, "<table>"), tables);
  EXPECT_EQ(times(html, "<tr>"), lines - tables);
  EXPECT_EQ(outcome_of(page), "1 answer agrees with the reference exact, 1 differs from it.");
}

TEST(ReportPage, IsWrittenBesideTheMarkdownWithPlotsPicturesAndTheReadme) {
  const TemporaryFolder folder;
  const auto readme =
      folder.write("study/README.md", "# t\n\n## Expected\n\nMuch, see [it](results/x.md) and [c](#d).\n");
  const Document page = report(example_study(), {}, example_rows(), "/nowhere");
  const auto file = write_pages(page, folder.path() / "study" / "work", readme);
  EXPECT_EQ(file, folder.path() / "study" / "work" / "report.html");
  EXPECT_EQ(pfv::read_text(folder.path() / "study" / "work" / "report.md"), to_markdown(page));
  const std::string html = pfv::read_text(file);
  EXPECT_EQ(times(html, "<figure>"), 5U); // three plots, two packings
  EXPECT_EQ(times(html, "<svg ") + times(html, "there is no gnuplot here"), 5U);
  EXPECT_EQ(times(html, "<circle cx"), 3U); // two spheres and one
  EXPECT_NE(html.find("<a href=\"../results/x.md\">it</a> and <a href=\"#d\">c</a>"), html.npos);
  EXPECT_EQ(html.find("http"), html.npos);
  // No two ids alike, though every picture of gnuplot has the same ones.
  std::set<std::string> ids;
  const std::regex id(" id=[\"']([^\"']*)[\"']");
  for (std::sregex_iterator it(html.begin(), html.end(), id), end; it != end; ++it)
    EXPECT_TRUE(ids.insert((*it)[1]).second) << it->str();
}

TEST(ReportPage, SaysWhichPictureIsMissing) {
  const TemporaryFolder folder;
  Document page{"t", {}};
  page.add(Figure{"a caption", "figure.svg"});
  const std::string html = pfv::read_text(write_pages(page, folder.path(), {}));
  EXPECT_NE(html.find("No picture: there is no figure.svg"), html.npos);
  folder.write("figure.svg", "<?xml?><svg width=\"1\" height=\"1\"></svg>");
  EXPECT_EQ(pfv::read_text(write_pages(page, folder.path(), {})).find("No picture"), html.npos);
}

TEST(ReportPlots, PermeabilityIsToldByCaseAndNearOneOnceMore) {
  const auto plots = permeability_plots(example_study(), example_results());
  ASSERT_EQ(plots.size(), 2U);
  EXPECT_EQ(plots[0].y.categories, (std::vector<std::string>{"one", "two"}));
  const auto& points = plots[0].series[0].points;
  ASSERT_EQ(points.size(), 2U);
  EXPECT_NEAR(points[0].x, 1.3, 1e-9);
  EXPECT_NEAR(points[1].x, 1.01, 1e-9);
  EXPECT_NEAR(*points[0].x_error, 1.25 * 0.04, 1e-9); // of the reference
  EXPECT_EQ(plots[1].x.range, std::pair(0.95, 1.05));
}

TEST(ReportPlots, NothingIsDrawnWithoutAReference) {
  Study study = example_study();
  study.reference = "openfoam";
  const auto list = results(study, example_rows(), "/nowhere");
  EXPECT_TRUE(permeability_plots(study, list).empty());
  EXPECT_TRUE(error_plot(study, list).empty());
}

TEST(ReportPlots, ErrorsAreOfEveryMeshAndOnlyAgainstAReferenceThatKnowsItsOwn) {
  const Plot plot = error_plot(example_study(), example_results());
  ASSERT_EQ(plot.series.size(), 5U); // runs and medians of two methods, the front
  EXPECT_EQ(plot.series[0].points.size(), 2U);
  EXPECT_EQ(plot.series[1].points.size(), 4U);
  EXPECT_NEAR(plot.series[0].points[0].y, 0.3, 1e-9);
  const auto& medians = plot.series.back().points; // of the reference, coarse to fine
  ASSERT_EQ(medians.size(), 2U);
  EXPECT_NEAR(medians[0].y, std::sqrt(0.16 * 0.08), 1e-9);
  std::vector<Row> one_mesh = example_rows();
  std::erase_if(one_mesh, [](const Row& row) { return row.mesh_size == 2; });
  EXPECT_TRUE(error_plot(example_study(), results(example_study(), one_mesh, "/nowhere")).empty());
}

TEST(ReportPlots, CostAgainstSpheresIsDrawnWhenAskedFor) {
  Study study = example_study();
  EXPECT_TRUE(scaling_plots(study, example_results()).empty());
  study.scaling = Scaling{};
  const auto plots = scaling_plots(study, results(study, example_rows(), "/nowhere"));
  ASSERT_EQ(plots.size(), 2U);
  EXPECT_EQ(plots[0].series.size(), 2U);
  EXPECT_TRUE(error_plot(study, example_results()).empty());
}

TEST(PackingPicture, HasEverySphereAndTellsTheLargestValue) {
  const pfv::Packing packing{{}, {{{0.3, 0.3, 0.3}, 0.2}, {{0.7, 0.7, 0.7}, 0.1}}};
  const std::vector<double> values{0.5, 2};
  const std::string svg = packing_picture(packing, values, "N", "p-");
  EXPECT_EQ(times(svg, "<circle"), 2U);
  EXPECT_NE(svg.find("url(#p-4)"), svg.npos); // a quarter of sixteen shades
  EXPECT_NE(svg.find("url(#p-15)"), svg.npos);
  EXPECT_NE(svg.find(">2 N<"), svg.npos);
  const std::string plain = packing_picture(packing, {}, "", "p-");
  EXPECT_EQ(times(plain, "<radialGradient"), 1U);
  EXPECT_EQ(plain.find("<text"), plain.npos);
}

TEST(IndexPage, LeadsToEveryReportAndSaysWhereThereIsNone) {
  const TemporaryFolder folder;
  write_pages(report(example_study(), {}, example_rows(), "/nowhere"), folder.path() / "a" / "results", {});
  const IndexEntry entries[] = {{"a", "", folder.path() / "a" / "results"}, {"b", "Title of b", folder.path() / "b"}};
  const std::string html = to_html(index_page(entries, folder.path()));
  EXPECT_NE(html.find("<a href=\"a/results/report.html\">a</a>"), html.npos);
  EXPECT_NE(html.find("A study"), html.npos);
  EXPECT_NE(html.find("1 answer agrees with the reference exact"), html.npos);
  EXPECT_NE(html.find("2000-01-01"), html.npos);
  EXPECT_NE(html.find("Title of b"), html.npos);
  EXPECT_NE(html.find("no report; <code>study run b</code> makes it"), html.npos);
}

} // namespace
} // namespace studies
