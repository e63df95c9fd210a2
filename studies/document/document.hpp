#pragma once

#include "studies/document/table.hpp"
#include "studies/plots/plot.hpp"

#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace studies {

// Texts are inline Markdown: *emphasis*, **strong**, `code` and [a link](to).

struct Heading {
  std::string text;
  int level = 2;
};

struct Paragraph {
  std::string text;
};

struct List {
  std::vector<std::string> items;
};

/// Lines as they are.
struct Code {
  std::string language;
  std::string text; // with its last line end
};

/// A picture from a file beside the page or from memory.
struct Figure {
  std::string caption;
  std::string file;         // beside the page; empty when there is none
  std::string picture = {}; // SVG fit to stand inside of a page, or PNG
  std::string why_not = {}; // there is no picture, a sentence without a full stop
};

struct Block;

/// What a reader looks up rather than reads: folded on a page.
struct Details {
  Heading heading;
  std::vector<Block> blocks;
};

struct Block {
  std::variant<Heading, Paragraph, List, Table, Code, Figure, Plot, Details> is;
};

/// A page, said once and written as Markdown and as HTML.
struct Document {
  std::string title;
  std::vector<Block> blocks;

  template <class Is>
  void add(Is is) {
    blocks.push_back({std::move(is)});
  }
};

/// What leads the paragraph that says how it came out, see outcome_of.
inline constexpr std::string_view outcome_lead = "**Outcome.** ";

/// The text of the first paragraph with that lead, without it; empty when there is none.
std::string outcome_of(const Document& document);

/// The value in the first row, of any table with the columns "what" and "value", that begins with this.
std::string fact_of(const Document& document, std::string_view what);

} // namespace studies
