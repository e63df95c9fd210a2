#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace studies {

using CsvRecord = std::vector<std::string>;

/// One record and its newline. A field with a comma, quote or line break is quoted, a quote inside it doubled (RFC
/// 4180).
std::string to_csv(const CsvRecord& record);

struct CsvText {
  std::vector<CsvRecord> records;
  std::size_t complete_bytes =
      0; // up to the end of the last whole record; what follows was torn off while being written
};

/// The whole records of a CSV text. A last record without its newline is left out: its writer was stopped half-way.
CsvText parse_csv(std::string_view text);

} // namespace studies
