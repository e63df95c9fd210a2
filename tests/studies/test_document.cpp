#include "studies/document/html.hpp"
#include "studies/document/inline_html.hpp"
#include "studies/document/markdown.hpp"
#include "tests/studies/example_document.hpp"
#include "tests/studies/times.hpp"

#include <gtest/gtest.h>

#include <regex>

namespace studies {
namespace {

// Without style and script.
std::string body(const std::string& html) {
  const auto begin = html.find("<body>"), end = html.find("<script>\n");
  return html.substr(begin, end - begin);
}

TEST(Markdown, BlocksAreApartByOneEmptyLine) {
  const std::string text = to_markdown(example_document());
  EXPECT_TRUE(text.starts_with("# Is 1 < 2 & \"so\"?\n\nA *small* question"));
  EXPECT_EQ(text.find("\n\n\n"), text.npos);
  EXPECT_NE(text.find("\n\n```sh\nstudy run x # <not a heading>\n\n- nor a list\n```\n\n### Smaller"), text.npos);
  EXPECT_TRUE(text.ends_with("\n\n## Runs\n\n| what | value |\n| --- | --- |\n| commit | abc |\n"));
}

TEST(Markdown, ReadsWhatItWrites) {
  const std::string text = to_markdown(example_document());
  EXPECT_EQ(to_markdown(from_markdown(text)), text);
  EXPECT_EQ(to_markdown(from_markdown("# t\n\nno end of line")), "# t\n\nno end of line\n");
  EXPECT_EQ(to_markdown(from_markdown("")), "# \n\n");
  EXPECT_EQ(to_markdown(from_markdown("# t\n```\nnever closed")), "# t\n\n```\nnever closed\n```\n");
}

TEST(Markdown, LeavesCommentsOut) {
  EXPECT_EQ(to_markdown(from_markdown("# t\n\n- a\n  b\n  <!--\n  c\n  -->\n<!-- d -->\n\ne\n")),
            "# t\n\n- a\n  b\n\ne\n");
}

TEST(Markdown, KeepsCellsAndSides) {
  const Document page = from_markdown(to_markdown(example_document()));
  for (const Block& block : page.blocks)
    if (const auto* table = std::get_if<Table>(&block.is); table && table->columns.size() == 3) {
      EXPECT_TRUE(table->columns[1].numbers);
      EXPECT_FALSE(table->columns[2].numbers);
      ASSERT_EQ(table->rows.size(), 5U);
      EXPECT_EQ(table->rows[2][1], "");
      EXPECT_EQ(table->rows[2][2], "one | two");
    }
}

TEST(Document, FindsOutcomeAndFacts) {
  const Document page = from_markdown(to_markdown(example_document()));
  EXPECT_EQ(outcome_of(page), "2 * 3 * 4 is 24;\nin two lines.");
  EXPECT_EQ(fact_of(page, "commit"), "abc");
  EXPECT_EQ(fact_of(page, "machine"), "");
}

TEST(InlineHtml, EscapesAndMarks) {
  EXPECT_EQ(inline_html("a < b & \"c\" > d"), "a &lt; b &amp; &quot;c&quot; &gt; d");
  EXPECT_EQ(inline_html("*a* and **b *c* d**"), "<em>a</em> and <strong>b <em>c</em> d</strong>");
  EXPECT_EQ(inline_html("`x < *y*`"), "<code>x &lt; *y*</code>");
  EXPECT_EQ(inline_html("[a *b*](../c.md)"), "<a href=\"../c.md\">a <em>b</em></a>");
  EXPECT_EQ(inline_html("[a](https://x.org/?a&b)"), "<a href=\"https://x.org/?a&amp;b\">a</a>");
}

TEST(InlineHtml, WithoutAPartnerAMarkIsItself) {
  for (const char* text : {"2 * 3 * 4", "2*3*4", "a*b", "*", "**", "****", "* a*", "`", "``", "[", "k [m²] (x)", "[a](",
                           "stages [CPU s]", "F_ref and |F|", "pore_volumes_sor"})
    EXPECT_EQ(inline_html(text), text);
}

TEST(InlineHtml, LinksOnlyToTheWebAndToFiles) {
  EXPECT_EQ(inline_html("[a](javascript:alert(1))").find("<a"), std::string::npos);
  EXPECT_EQ(inline_html("[a](data:text/html,x)").find("<a"), std::string::npos);
}

TEST(Html, HasEveryRowAndNothingUnescaped) {
  const std::string html = body(to_html(example_document()));
  EXPECT_EQ(times(html, "<table>"), 2U);
  EXPECT_EQ(times(html, "<tr>"), 2U + 5U + 1U);
  EXPECT_EQ(times(html, "<td"), 5U * 3U + 2U);
  EXPECT_EQ(html.find("<script"), html.npos);
  EXPECT_NE(html.find("&lt;script&gt;alert(1)&lt;/script&gt;"), html.npos);
  EXPECT_NE(html.find("say &quot;hi&quot;, A &amp; B"), html.npos);
  EXPECT_NE(html.find(">one | two<"), html.npos);
  EXPECT_NE(html.find("<pre><code>study run x # &lt;not a heading&gt;\n\n- nor a list\n</code></pre>"), html.npos);
  EXPECT_NE(html.find("<p class=\"missing\">No picture: there is none.</p>"), html.npos);
}

TEST(Html, NeedsNoOtherFile) {
  const std::string html = to_html(example_document());
  EXPECT_NE(html.find("src=\"data:image/png;base64,iVBORw==\""), html.npos);
  const std::regex reference(R"re((src|href|srcset|data|action)\s*=\s*["']([^"']*)["'])re");
  for (std::sregex_iterator it(html.begin(), html.end(), reference), end; it != end; ++it) {
    const std::string name = (*it)[1], target = (*it)[2];
    const bool is_link = name == "href" && (target.starts_with("#") || target == "../README.md");
    EXPECT_TRUE(is_link || target.starts_with("data:")) << it->str();
  }
  for (const char* loading : {"<link", "@import", "<iframe", "fetch(", "http://", "https://", "Storage"})
    EXPECT_EQ(html.find(loading), html.npos) << loading;
}

TEST(Html, EveryLinkIntoThePageArrives) {
  Document page = example_document();
  page.add(Heading{"Results"}); // once more
  const std::string html = to_html(page);
  const std::regex link("href=\"#([^\"]*)\"");
  std::size_t links = 0;
  for (std::sregex_iterator it(html.begin(), html.end(), link), end; it != end; ++it, ++links)
    EXPECT_EQ(times(html, " id=\"" + (*it)[1].str() + "\""), 1U) << it->str();
  EXPECT_EQ(links, 3U);
}

} // namespace
} // namespace studies
