// The page as a browser sees it, from a file: its script runs without a complaint, sorts and copies.
#include "meshing/child_process.hpp"
#include "pfv/problem/text.hpp"
#include "reference/on_path.hpp"
#include "studies/document/html.hpp"
#include "tests/studies/example_document.hpp"
#include "tests/studies/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <sstream>
#include <string>

namespace studies {
namespace {

/// Empty when there is none.
std::string browser() {
  for (const char* name : {"chromium", "google-chrome"})
    if (reference::on_path(name))
      return name;
  return "";
}

/// What the page has become after its script and `more` have run, and what was logged meanwhile.
std::string page_after(const std::string& more) {
  const TemporaryFolder folder;
  std::string html = to_html(example_document());
  html.insert(html.rfind("</body>"), "<script>\n" + more + "</script>\n");
  const auto page = folder.write("page.html", html), log = folder.path() / "log";
  const auto ended = meshing::run_child(
      {browser(), "--headless", "--disable-gpu", "--no-sandbox", "--enable-logging=stderr", "--v=0",
       "--user-data-dir=" + (folder.path() / "profile").string(), "--dump-dom", "file://" + page.string()},
      {.log = log, .wall_limit = 120});
  EXPECT_TRUE(ended.succeeded()) << ended.how_it_ended();
  return pfv::read_text(log);
}

/// Complaints of the script and what the page says of itself.
std::string said(const std::string& page) {
  std::string lines;
  std::istringstream in(page);
  for (std::string line; std::getline(in, line);)
    if (line.find("CONSOLE") != line.npos || line.starts_with("<html"))
      lines += '\n' + line;
  return lines;
}

TEST(PageInBrowser, ScriptRunsSortsAndCopies) {
  if (browser().empty())
    GTEST_SKIP() << "no chromium or google-chrome to open the page with";
  const std::string page = page_after(R"js(
    const table = document.querySelector("table"), root = document.documentElement;
    const first = () => [...table.tBodies[0].rows].map((row) => row.cells[0].textContent).join("");
    const title = (column) => table.tHead.rows[0].cells[column];
    const orders = [first()];
    for (const column of [1, 1, 1, 0]) {
      title(column).click();
      orders.push(first() + "/" + title(column).getAttribute("aria-sort"));
    }
    root.dataset.orders = orders.join(" ");
    root.dataset.values = ["+32 % ± 0.3 %", "(8 ± 0.2)e-4", "1.7 GB", "2000 to 20000", "n.a.", "-5e-3"].map(report.value).join(" ");
    const paper = () => getComputedStyle(document.body).backgroundColor;
    const before = paper();
    document.querySelector("header > button").click();
    root.dataset.switched = paper() !== before;
  )js");
  const auto has = [&](const std::string& what) { EXPECT_NE(page.find(what), page.npos) << what << said(page); };
  has("data-ready=\"2\"");
  has("data-values=\"32 0.0008 1700000000 2000 NaN -0.005\"");
  // Numbers by size, then texts, the empty cell last; the third click puts all back.
  has("data-orders=\"bacde badec/ascending dabec/descending bacde/none abcde/ascending\"");
  has("data-switched=\"true\"");
  EXPECT_EQ(page.find("CONSOLE"), page.npos) << said(page);
}

TEST(PageInBrowser, CopiesByTheRulesOfCsv) {
  if (browser().empty())
    GTEST_SKIP() << "no chromium or google-chrome to open the page with";
  const std::string page = page_after(R"js(
    const lines = report.csv(document.querySelector("table")).split("\n");
    const expected = ['name,value,note', 'b,(1.20 ± 0.04)e-3,<script>alert(1)<' + '/script>',
      'a,877 kB,"say ""hi"", A & B"', 'c,,one | two', 'd,1.5 GB,not run', 'e,unresolved (< 0.3 %),agrees', ''];
    document.documentElement.dataset.same = lines.join("\n") === expected.join("\n");
  )js");
  EXPECT_NE(page.find("data-same=\"true\""), page.npos) << said(page);
}

} // namespace
} // namespace studies
