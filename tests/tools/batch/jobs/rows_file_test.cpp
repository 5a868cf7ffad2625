#include "tools/batch/jobs/rows_file.hpp"

#include <gtest/gtest.h>

#include "tests/tools/support/temporary.hpp"
#include "tools/base/files/file.hpp"
#include "tools/batch/jobs/row_line.hpp"

namespace castaway::testbed {
namespace {

std::string row_of(int job) { return done_row_line(job, std::to_string(10 * job)); }

TEST(RowsFile, IsIndexedByJob) {
  const TemporaryFolder folder;
  {
    const RowsFile file(folder.path() / "rows.jsonl");
    for (const int job : {3, 0, 1}) file.add(row_of(job));
  }
  RowIndex rows(folder.path(), 5);
  EXPECT_EQ(rows.jobs(), (std::vector<int>{0, 1, 3}));
  for (const int job : {0, 1, 3, 1}) {
    EXPECT_TRUE(rows.has(job));
    EXPECT_EQ(result_of_row(rows.line(job)), std::to_string(10 * job));
  }
}

TEST(RowsFile, OfAFolderThatIsNotThereHasNoRow) {
  EXPECT_TRUE(RowIndex("/nowhere/at/all", 2).jobs().empty());
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
  { RowsFile(path).add(row_of(0)); }
  const std::string whole = read_file(path);
  folder.put("rows.jsonl", whole + whole.substr(0, 20));
  EXPECT_EQ(RowIndex(folder.path(), 2).jobs(), std::vector<int>{0});
  { RowsFile(path).add(row_of(1)); }
  EXPECT_EQ(RowIndex(folder.path(), 2).jobs(), (std::vector<int>{0, 1}));
  folder.put("rows.jsonl", "{\"index\"");
  { RowsFile(path).add(row_of(1)); }
  EXPECT_EQ(RowIndex(folder.path(), 2).jobs(), std::vector<int>{1});
}

TEST(RowsFile, TheLastRowOfAJobCounts) {
  const TemporaryFolder folder;
  {
    const RowsFile file(folder.path() / "rows.jsonl");
    file.add(failed_row_line(0, "broken"));
    file.add(failed_row_line(1, "broken"));
    file.add(row_of(0));
  }
  const RowIndex rows(folder.path(), 2);
  EXPECT_FALSE(rows.has_failed(0));
  EXPECT_TRUE(rows.has_failed(1));
}

TEST(RowsFile, AJobIsInOneFileOnly) {
  const TemporaryFolder folder;
  { RowsFile(folder.path() / rows_name({1, 2})).add(row_of(0)); }
  { RowsFile(folder.path() / rows_name({2, 2})).add(row_of(1)); }
  EXPECT_EQ(RowIndex(folder.path(), 2).jobs(), (std::vector<int>{0, 1}));
  { RowsFile(folder.path() / rows_name({2, 2})).add(row_of(0)); }
  const std::string error = error_of([&] { RowIndex(folder.path(), 2); });
  EXPECT_TRUE(contains(error, "rows-2-of-2.jsonl:2: index 0 is in"));
}

TEST(RowsFile, RefusesOtherBatchesAndOtherFiles) {
  const TemporaryFolder folder;
  { RowsFile(folder.path() / "rows.jsonl").add(row_of(5)); }
  EXPECT_TRUE(
      contains(error_of([&] { RowIndex(folder.path(), 5); }), ":1: index 5 is of no row here"));
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
