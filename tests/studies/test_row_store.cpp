#include "studies/runner/row_store.hpp"

#include "pfv/problem/error.hpp"
#include "pfv/problem/text.hpp"
#include "tests/studies/example_row.hpp"
#include "tests/studies/temporary_folder.hpp"

#include <gtest/gtest.h>

namespace {

using studies::read_rows;
using studies::RowStore;

TEST(RowStore, KeepsWhatWasAppended) {
  const TemporaryFolder folder;
  {
    RowStore store(folder.path() / "new" / "work");
    store.append(example_row("a"));
    store.append(example_row("b"));
  }
  RowStore store(folder.path() / "new" / "work");
  store.append(example_row("c"));
  const std::vector expected{example_row("a"), example_row("b"), example_row("c")};
  EXPECT_EQ(store.rows(), expected);
  EXPECT_EQ(read_rows(folder.path() / "new" / "work" / "rows.csv"), expected);
}

TEST(RowStore, GoesOnAfterALineTornAtAnyByte) {
  const TemporaryFolder folder;
  { RowStore(folder.path()).append(example_row("a")); }
  const auto file = folder.path() / "rows.csv";
  const std::string whole = pfv::read_text(file);
  studies::Row torn = example_row("b");
  torn.message = "two\nlines, \"quoted\"";
  const std::string line = studies::to_csv(studies::to_record(torn));
  for (std::size_t kept = 0; kept < line.size(); kept += 7) {
    folder.write("rows.csv", whole + line.substr(0, kept));
    EXPECT_EQ(read_rows(file).size(), 1U);
    RowStore(folder.path()).append(example_row("c"));
    EXPECT_EQ(read_rows(file), (std::vector{example_row("a"), example_row("c")})) << kept << " bytes were left";
  }
}

TEST(RowStore, GoesOnAfterATornHeader) {
  const TemporaryFolder folder;
  folder.write("rows.csv", "key,stu");
  RowStore(folder.path()).append(example_row("a"));
  EXPECT_EQ(read_rows(folder.path() / "rows.csv"), std::vector{example_row("a")});
}

TEST(RowStore, ForgetsWhenAsked) {
  const TemporaryFolder folder;
  { RowStore(folder.path()).append(example_row("a")); }
  EXPECT_TRUE(RowStore(folder.path(), true).rows().empty());
  EXPECT_TRUE(read_rows(folder.path() / "rows.csv").empty());
}

TEST(RowStore, RefusesRowsOfAnotherVersionUnlessFresh) {
  const TemporaryFolder folder;
  folder.write("rows.csv", "key,other\n1,2\n");
  EXPECT_THROW(RowStore store(folder.path()), pfv::InputError);
  EXPECT_NO_THROW(RowStore store(folder.path(), true));
}

TEST(RowStore, IsHeldByOneAtATime) {
  const TemporaryFolder folder;
  const RowStore first(folder.path());
  EXPECT_THROW(RowStore second(folder.path()), pfv::InputError);
}

} // namespace
