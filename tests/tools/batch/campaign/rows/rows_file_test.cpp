#include "tools/batch/campaign/rows/rows_file.hpp"

#include <gtest/gtest.h>

#include "tests/tools/support/temporary.hpp"
#include "tools/base/files/file.hpp"

namespace castaway::testbed {
namespace {

CellRow row_of_cell(int index, CellOutcome state = CellOutcome::kDone) {
  CellRow row;
  row.index = index;
  row.state = state;
  row.metrics["distance_m"] = 10.0 * index;
  return row;
}

TEST(RowsFile, IsIndexedByCell) {
  const TemporaryFolder folder;
  {
    const RowsFile file(folder.path() / "rows.jsonl");
    for (const int cell : {3, 0, 1}) file.add(row_of_cell(cell));
  }
  RowIndex rows(folder.path(), 5);
  EXPECT_EQ(rows.cells(), (std::vector<int>{0, 1, 3}));
  for (const int cell : {0, 1, 3, 1}) {
    EXPECT_TRUE(rows.has(cell));
    EXPECT_EQ(rows.row(cell).metrics.at("distance_m"), 10.0 * cell);
  }
}

TEST(RowsFile, OfAFolderThatIsNotThereHasNoRow) {
  EXPECT_TRUE(RowIndex("/nowhere/at/all", 2).cells().empty());
}

TEST(RowsFile, IsNoLink) {
  const TemporaryFolder folder;
  folder.put("mine", "my notes");
  std::filesystem::create_symlink("mine", folder.path() / "rows.jsonl");
  EXPECT_TRUE(contains(error_of([&] { RowsFile(folder.path() / "rows.jsonl"); }), "is a link"));
  EXPECT_TRUE(contains(error_of([&] { RowIndex(folder.path(), 2); }), "is a link"));
  EXPECT_EQ(read_file(folder.path() / "mine"), "my notes");
}

TEST(RowsFile, DropsALineThatWasHalfWritten) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "rows.jsonl";
  { RowsFile(path).add(row_of_cell(0)); }
  const std::string whole = read_file(path);
  folder.put("rows.jsonl", whole + whole.substr(0, 20));
  EXPECT_EQ(RowIndex(folder.path(), 2).cells(), std::vector<int>{0});
  { RowsFile(path).add(row_of_cell(1)); }
  EXPECT_EQ(RowIndex(folder.path(), 2).cells(), (std::vector<int>{0, 1}));
  folder.put("rows.jsonl", "{\"index\"");
  { RowsFile(path).add(row_of_cell(1)); }
  EXPECT_EQ(RowIndex(folder.path(), 2).cells(), std::vector<int>{1});
}

TEST(RowsFile, TheLastRowOfACellCounts) {
  const TemporaryFolder folder;
  {
    const RowsFile file(folder.path() / "rows.jsonl");
    file.add(row_of_cell(0, CellOutcome::kFailed));
    file.add(row_of_cell(1, CellOutcome::kFailed));
    file.add(row_of_cell(0));
  }
  const RowIndex rows(folder.path(), 2);
  EXPECT_FALSE(rows.has_failed(0));
  EXPECT_TRUE(rows.has_failed(1));
}

TEST(RowsFile, ACellIsInOneFileOnly) {
  const TemporaryFolder folder;
  { RowsFile(folder.path() / rows_name(1, 2)).add(row_of_cell(0)); }
  { RowsFile(folder.path() / rows_name(2, 2)).add(row_of_cell(1)); }
  EXPECT_EQ(RowIndex(folder.path(), 2).cells(), (std::vector<int>{0, 1}));
  { RowsFile(folder.path() / rows_name(2, 2)).add(row_of_cell(0)); }
  const std::string error = error_of([&] { RowIndex(folder.path(), 2); });
  EXPECT_TRUE(contains(error, "rows-2-of-2.jsonl:2: cell 0 is in"));
}

TEST(RowsFile, RefusesOtherCampaignsAndOtherFiles) {
  const TemporaryFolder folder;
  { RowsFile(folder.path() / "rows.jsonl").add(row_of_cell(5)); }
  EXPECT_TRUE(contains(error_of([&] { RowIndex(folder.path(), 5); }), ":1: no cell"));
  folder.put("rows.jsonl", "hello\n");
  EXPECT_TRUE(contains(error_of([&] { RowIndex(folder.path(), 5); }), ":1: is no row"));
}

TEST(RowsFile, OneProcessAddsAtATime) {
  const TemporaryFolder folder;
  const RowsFile file(folder.path() / "rows.jsonl");
  EXPECT_TRUE(contains(error_of([&] { RowsFile(folder.path() / "rows.jsonl"); }), "another"));
}

}  // namespace
}  // namespace castaway::testbed
