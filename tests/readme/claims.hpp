#pragma once

#include "readme/committed.hpp"

#include <filesystem>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace readme {

/// A paragraph, a list or a table, with what the comment at its end says of its numbers. The comment is a list of
///     given 0.1, 17                     of the question, no measurement
///     38 % = 100 (1.288 / 0.9308 - 1)   derived from committed numbers, see derive()
///     from results/moments.csv          held by this file too, as by one that the text links to
///     by rows                           each row of the table is found in one line of the results
/// one a line.
struct Block {
  std::filesystem::path file;
  std::size_t line = 0; // its first
  std::string heading;  // it stands under
  std::vector<std::string> text;
  std::vector<std::string> says;
};

std::vector<Block> blocks_of(const std::filesystem::path& readme);

/// The files that hold a block, as it gives them: by `from` or by a link to a report.md or a CSV.
std::set<std::string> sources_of(const Block& block);

/// What came of a block's numbers.
struct Held {
  std::vector<Number> found;         // in the results
  std::size_t declared = 0;          // given or derived
  std::vector<std::string> problems; // a line each
};

Held hold(const Block& block, const std::vector<Committed>& results);

} // namespace readme
