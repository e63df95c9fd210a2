#pragma once

#include "readme/numbers.hpp"

#include <filesystem>
#include <functional>
#include <string_view>

namespace readme {

/// What an expression may speak of.
struct Sources {
  std::function<bool(const Number&)> is_known; // asked of each number but 1, 2, 60, 100 and 1000
  std::filesystem::path folder;                // that of the CSV files it names
};

/// The value of an expression of + - * / ( ) over numbers; two that stand side by side are multiplied. Also count, max,
/// mean, min, rms or sum of a list, or of a column:
///     max(0.1, 0.2)
///     rms(ln_ratio of results/fit.csv for random*)
/// with the rows that `for` names, see column(). Throws std::runtime_error that names what is not known or not
/// understood.
double derive(std::string_view expression, const Sources& sources);

} // namespace readme
