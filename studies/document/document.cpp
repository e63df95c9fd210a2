#include "studies/document/document.hpp"

namespace studies {

std::string outcome_of(const Document& document) {
  for (const Block& block : document.blocks)
    if (const auto* paragraph = std::get_if<Paragraph>(&block.is);
        paragraph && paragraph->text.starts_with(outcome_lead))
      return paragraph->text.substr(outcome_lead.size());
  return "";
}

std::string fact_of(const Document& document, std::string_view what) {
  for (const Block& block : document.blocks)
    if (const auto* table = std::get_if<Table>(&block.is);
        table && table->columns.size() == 2 && table->columns[0].title == "what" && table->columns[1].title == "value")
      for (const auto& row : table->rows)
        if (row[0] == what)
          return row[1];
  return "";
}

} // namespace studies
