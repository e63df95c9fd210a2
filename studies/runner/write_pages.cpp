#include "studies/runner/write_pages.hpp"

#include "pfv/problem/text.hpp"
#include "studies/document/html.hpp"
#include "studies/document/markdown.hpp"
#include "studies/plots/draw.hpp"
#include "studies/plots/svg_for_pages.hpp"
#include "studies/runner/files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <regex>

namespace studies {

namespace {

/// Every picture of a page into the page.
class Illustrator {
public:
  explicit Illustrator(std::filesystem::path folder) : folder_(std::move(folder)) {}

  void illustrate(std::vector<Block>& blocks) {
    for (Block& block : blocks) {
      if (const auto* plot = std::get_if<Plot>(&block.is)) {
        Drawing drawing = draw(*plot, next_prefix());
        block.is = Figure{plot->caption, "", std::move(drawing.svg), std::move(drawing.why_not)};
      } else if (auto* figure = std::get_if<Figure>(&block.is); figure && figure->picture.empty())
        fetch(*figure);
      else if (auto* details = std::get_if<Details>(&block.is))
        illustrate(details->blocks);
    }
  }

private:
  std::string next_prefix() { return fmt::format("f{}-", ++figures_); }

  void fetch(Figure& figure) {
    const auto file = folder_ / figure.file;
    if (!std::filesystem::is_regular_file(file))
      figure.why_not = fmt::format("there is no {}, which gnuplot draws", figure.file);
    else if (file.extension() == ".svg")
      figure.picture = svg_for_pages(pfv::read_text(file), next_prefix());
    else
      figure.picture = pfv::read_text(file);
  }

  std::filesystem::path folder_;
  int figures_ = 0;
};

/// What a study says of itself, with its links as they are from another folder.
Details about_the_study(const std::filesystem::path& readme, const std::filesystem::path& folder) {
  static const std::regex link(R"(\]\((?![a-z]+:|#|/))");
  const auto way = std::filesystem::relative(readme.parent_path(), folder).generic_string();
  Document about = from_markdown(std::regex_replace(pfv::read_text(readme), link, "](" + way + "/"));
  for (Block& block : about.blocks)
    if (auto* heading = std::get_if<Heading>(&block.is))
      heading->level = std::max(heading->level, 3);
  return {Heading{"What was expected and found"}, std::move(about.blocks)};
}

} // namespace

std::filesystem::path write_pages(Document document, const std::filesystem::path& folder,
                                  const std::filesystem::path& readme) {
  write_file(folder / "report.md", to_markdown(document));
  if (std::filesystem::is_regular_file(readme))
    document.add(about_the_study(readme, folder));
  Illustrator(folder).illustrate(document.blocks);
  const auto page = folder / "report.html";
  write_file(page, to_html(document));
  return page;
}

} // namespace studies
