#pragma once

#include "studies/document/document.hpp"

/// A page with every kind of block and what is hard to write: < & " | and marks without partners.
inline studies::Document example_document() {
  using namespace studies;
  Document page{"Is 1 < 2 & \"so\"?", {}};
  page.add(Paragraph{"A *small* question, **strongly** asked, with `code <b>` and [a link](../README.md)."});
  page.add(Paragraph{"**Outcome.** 2 * 3 * 4 is 24;\nin two lines."});
  page.add(Heading{"Results"});
  page.add(Table{{{"name"}, {"value", true}, {"note"}},
                 {{"b", "(1.20 ± 0.04)e-3", "<script>alert(1)</script>"},
                  {"a", "877 kB", "say \"hi\", A & B"},
                  {"c", "", "one | two"},
                  {"d", "1.5 GB", "not run"},
                  {"e", "unresolved (< 0.3 %)", "agrees"}}});
  page.add(List{{"first *item*", "second"}});
  page.add(Figure{"A <figure>", "figure.png", "\x89PNG", ""});
  page.add(Code{"sh", "study run x # <not a heading>\n\n- nor a list\n"});
  page.add(Heading{"Smaller", 3});
  page.add(Figure{"None", "gone.svg", "", "there is none"});
  page.add(Details{Heading{"Runs"}, {{Table{{{"what"}, {"value"}}, {{"commit", "abc"}}}}}});
  return page;
}
