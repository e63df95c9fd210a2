#pragma once

#include "readme/numbers.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace readme {

/// What a study has committed: the numbers of each line of its results.
struct Committed {
  std::vector<std::vector<Number>> lines;

  bool has(const Number& claimed) const;
  /// All of them in one line: a row of a table.
  bool has_in_one_line(const std::vector<Number>& claimed) const;
};

/// The lines of a report.md up to its single runs, or the rows of a CSV with a header. The unit
/// of a column is that of its title ([CPU s], µs per step, cpu_s, bytes) where a cell has none. Throws when there is no
/// such file.
Committed read_committed(const std::filesystem::path& file);

} // namespace readme
