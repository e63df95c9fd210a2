#include "studies/runner/csv.hpp"

#include <utility>

namespace studies {

namespace {

std::string quoted(const std::string& field) {
  if (field.find_first_of(",\"\n\r") == std::string::npos)
    return field;
  std::string text = "\"";
  for (const char c : field) {
    if (c == '"')
      text += '"';
    text += c;
  }
  text += '"';
  return text;
}

} // namespace

std::string to_csv(const CsvRecord& record) {
  std::string line;
  for (std::size_t i = 0; i < record.size(); ++i)
    line.append(i == 0 ? "" : ",").append(quoted(record[i]));
  line += '\n';
  return line;
}

CsvText parse_csv(std::string_view text) {
  CsvText result;
  CsvRecord record;
  std::string field;
  bool inside_quotes = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (inside_quotes) {
      if (c != '"')
        field += c;
      else if (i + 1 < text.size() && text[i + 1] == '"')
        field += text[++i];
      else
        inside_quotes = false;
    } else if (c == '"') {
      inside_quotes = true;
    } else if (c == ',') {
      record.push_back(std::exchange(field, {}));
    } else if (c == '\n') {
      record.push_back(std::exchange(field, {}));
      result.records.push_back(std::exchange(record, {}));
      result.complete_bytes = i + 1;
    } else {
      field += c;
    }
  }
  return result;
}

} // namespace studies
