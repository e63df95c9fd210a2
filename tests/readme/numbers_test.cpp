// Every number that the project's pages say was measured is one that is committed. In the README of a study that is
// what stands under "Found", held by the study's results/report.md, or by its CSV files where there is no report; on
// all other pages each paragraph and table that names results, and none with a percentage, a time or a memory may name
// none.
#include "readme/claims.hpp"
#include "readme/derive.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <iostream>

namespace readme {
namespace {

namespace fs = std::filesystem;

const fs::path project = PROJECT_FOLDER;
const fs::path studies = project / "studies";

/// What a study published: its report, or all CSV files where there is none.
std::set<fs::path> results_of(const std::string& study) {
  const fs::path folder = studies / study / "results";
  if (fs::exists(folder / "report.md"))
    return {folder / "report.md"};
  std::set<fs::path> files;
  for (const auto& file : fs::directory_iterator(folder))
    if (file.path().extension() == ".csv")
      files.insert(file);
  return files;
}

struct Claim {
  std::string place; // file:line
  Block block;
  std::vector<Committed> results;
};

bool is_found(const std::string& heading) {
  return heading == "Found" || heading == "What was found";
}

std::vector<std::string> studies_with_results() {
  std::vector<std::string> names;
  for (const auto& folder : fs::directory_iterator(studies))
    if (fs::is_directory(folder.path() / "results"))
      names.push_back(folder.path().filename());
  return names;
}

/// The blocks of a README that results hold, those of `study` too under "Found".
std::vector<Claim> claims_of(const fs::path& readme, const std::string& study) {
  std::vector<Claim> claims;
  for (const Block& block : blocks_of(readme)) {
    std::set<fs::path> files;
    if (!study.empty() && is_found(block.heading))
      files = results_of(study);
    else if (!study.empty())
      continue;
    for (const std::string& source : sources_of(block))
      files.insert(fs::weakly_canonical(readme.parent_path() / source));
    Claim claim{readme.string() + ":" + std::to_string(block.line), block, {}};
    for (const fs::path& file : files)
      claim.results.push_back(read_committed(file));
    if (!files.empty())
      claims.push_back(std::move(claim));
  }
  return claims;
}

/// All pages but the READMEs of studies, what tests are made of, and what a machine has written.
std::vector<fs::path> plain_pages() {
  std::vector<fs::path> pages{project / "README.md"};
  for (const char* folder : {"pfv", "reference", "meshing"})
    for (const auto& file : fs::recursive_directory_iterator(project / folder))
      if (file.path().extension() == ".md")
        pages.push_back(file.path());
  return pages;
}

std::vector<Claim> all_claims() {
  std::vector<Claim> claims;
  for (const fs::path& page : plain_pages())
    for (Claim& claim : claims_of(page, ""))
      claims.push_back(std::move(claim));
  for (const std::string& study : studies_with_results())
    for (Claim& claim : claims_of(studies / study / "README.md", study))
      claims.push_back(std::move(claim));
  return claims;
}

/// The number as it would stand there after a run with another result.
Number stale(Number number, double by) {
  number.value = number.value * (1 + by) + (by > 0 ? 1 : -1) * number.step;
  return number;
}

TEST(Readme, NumbersAreCommitted) {
  std::size_t found = 0, declared = 0, would_be_caught = 0, stale_ones = 0, blocks = 0, blocks_caught = 0;
  for (const Claim& claim : all_claims()) {
    const Held held = hold(claim.block, claim.results);
    for (const std::string& problem : held.problems)
      ADD_FAILURE() << claim.place << ": " << problem;
    found += held.found.size();
    declared += held.declared;
    for (const double by : {-0.07, 0.07}) {
      const auto caught = std::ranges::count_if(held.found, [&](const Number& number) {
        return std::ranges::none_of(claim.results, [&](const Committed& is) { return is.has(stale(number, by)); });
      });
      stale_ones += held.found.size();
      would_be_caught += static_cast<std::size_t>(caught);
      if (held.found.size() >= 6) {
        ++blocks;
        blocks_caught += caught > 0;
      }
    }
  }
  std::cout << found << " numbers found in the results, " << declared << " declared, " << would_be_caught << " of "
            << stale_ones << " stale ones caught, in " << blocks_caught << " of " << blocks << " stale paragraphs\n";
  EXPECT_GE(found, 400u);
  // Each by itself may round to some other number of the report, as half of them do; a paragraph's do not all.
  EXPECT_GE(would_be_caught, 0.4 * stale_ones);
  EXPECT_GE(blocks, 30u);
  EXPECT_GE(blocks_caught, 0.9 * blocks);
}

TEST(Readme, EveryMeasuredParagraphNamesResults) {
  EXPECT_GE(plain_pages().size(), 5u);
  for (const fs::path& page : plain_pages())
    for (const Block& block : blocks_of(page))
      for (const std::string& line : block.text)
        for (const Number& number : numbers_in(line))
          EXPECT_TRUE(number.unit == Unit::none || !sources_of(block).empty())
              << page.string() << ':' << block.line << ": " << number.text << " is held by nothing";
}

TEST(Readme, AStaleRowOfTheFirstTableIsCaught) {
  auto claims = all_claims();
  const auto table =
      std::ranges::find_if(claims, [](const Claim& is) { return is.block.text[0].starts_with("| spheres"); });
  ASSERT_NE(table, claims.end());
  ASSERT_TRUE(hold(table->block, table->results).problems.empty());
  std::size_t tried = 0, caught = 0;
  for (std::string& row : table->block.text)
    for (const Number& number : numbers_in(row)) {
      if (number.value == 0 || number.step > 0.2 * std::abs(number.value))
        continue; // another run may well give the same
      const std::string before = row;
      const auto at = row.find(number.text) + (number.text.starts_with('(') || number.has_sign ? 1 : 0);
      row[at] = row[at] == '9' ? '8' : static_cast<char>(row[at] + 1);
      ++tried;
      caught += !hold(table->block, table->results).problems.empty();
      row = before;
    }
  EXPECT_GE(tried, 90u);
  EXPECT_GE(caught, 0.95 * tried);
}

TEST(Numbers, AreReadAsTheyArePrinted) {
  const auto read = [](std::string_view text) {
    std::string all;
    for (const Number& is : numbers_in(text))
      all += fmt::format("{:g}{}{} ", is.value, is.bar ? fmt::format("+-{:g}", *is.bar) : "",
                         is.unit == Unit::percent   ? "%"
                         : is.unit == Unit::seconds ? "s"
                         : is.unit == Unit::bytes   ? "B"
                                                    : "");
    return all;
  };
  EXPECT_EQ(read("(8.504 ± 0.058)e-4 m², +37 % ± 0.8 %"), "0.0008504+-5.8e-06 37+-0.8% ");
  EXPECT_EQ(read("120 888 and 2.9e6; 16, 13 and 12 % rms in 5.4 s and 1.7 GB"),
            "120888 2.9e+06 16% 13% 12% 5.4s 1.7B ");
  EXPECT_EQ(read("13-15 % of `g200 7`, [1](2.md), Table 3, g200, 4a, 2^23, -0.5"), "13% 15% -0.5 ");
}

TEST(Numbers, RoundAtTheDigitsThatArePrinted) {
  const auto holds = [](const char* committed, const char* claimed) {
    return rounds_to(numbers_in(committed).at(0), numbers_in(claimed).at(0));
  };
  EXPECT_TRUE(holds("0.0271", "0.03"));
  EXPECT_FALSE(holds("0.0271", "0.02"));
  EXPECT_TRUE(holds("1062", "1060"));
  EXPECT_FALSE(holds("1066", "1060"));
  EXPECT_TRUE(holds("679 µs", "0.68 ms"));
  EXPECT_FALSE(holds("37", "37 %"));
  EXPECT_TRUE(holds("-1.5 %", "1.5 %"));
  EXPECT_FALSE(holds("-1.5 %", "+1.5 %"));
  EXPECT_FALSE(holds("(8.504 ± 0.058)e-4", "(8.504 ± 0.061)e-4"));
}

TEST(Numbers, AreDerivedFromKnownOnes) {
  const Sources known{[](const Number& number) { return number.value == 1.5 || number.value == 3; }, project};
  EXPECT_DOUBLE_EQ(derive("100 (3 / 1.5 - 1)", known), 100);
  EXPECT_DOUBLE_EQ(derive("rms(3, 1, -3, 1) / 1", known), std::sqrt(5));
  EXPECT_DOUBLE_EQ(derive("1000 max(1.5, 2 * 3)", known), 6000);
  EXPECT_THROW(derive("3 / 1.6", known), std::runtime_error);
  EXPECT_THROW(derive("(3 / 1.5", known), std::runtime_error);
  EXPECT_THROW(derive("max(3, 1.5", known), std::runtime_error);
}

TEST(Numbers, AreDerivedFromColumns) {
  const Sources sources{[](const Number&) { return false; }, project};
  const std::string column = "(permeability of tests/data/peer_permeability.csv";
  EXPECT_DOUBLE_EQ(derive("max" + column + ")", sources), 7.977212e-4);
  EXPECT_DOUBLE_EQ(derive("count" + column + ")", sources), 3);
  EXPECT_DOUBLE_EQ(derive("sum" + column + " for g200)", sources), 7.393406e-5);
  EXPECT_DOUBLE_EQ(derive("min" + column + " for g200* 11645)", sources), 1.087566e-5);
  EXPECT_THROW(derive("min" + column + " for g200* 1)", sources), std::runtime_error);
  EXPECT_THROW(derive("min(permeable of tests/data/peer_permeability.csv)", sources), std::runtime_error);
}

TEST(Readme, EveryStudyWithResultsSaysWhatItFound) {
  EXPECT_GE(studies_with_results().size(), 12u);
  for (const std::string& study : studies_with_results()) {
    const auto blocks = blocks_of(studies / study / "README.md");
    EXPECT_TRUE(std::ranges::any_of(blocks, [](const Block& is) { return is_found(is.heading); }))
        << study << " has results and no section Found";
  }
}

} // namespace
} // namespace readme
