#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace readme {

/// The cells of a row, parted at a separator outside of "quotes".
std::vector<std::string> cells_of(std::string_view row, char separator);

/// The numbers of one column of a CSV, in the rows that have a cell for every word: one that is equal to it or, where
/// the word ends with *, begins with it. Cells that hold no number are left out. Throws std::runtime_error when there
/// is no such file, column or row.
std::vector<double> column(const std::filesystem::path& file, const std::string& title,
                           const std::vector<std::string>& words);

} // namespace readme
