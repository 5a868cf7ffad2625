#include "tools/base/output/listed_files.hpp"

#include <gtest/gtest.h>

#include "tests/tools/support/temporary.hpp"
#include "tools/base/bytes/sha256.hpp"

namespace castaway::testbed {
namespace {

namespace fs = std::filesystem;

/// Writes a folder with two files of castaway.
FileRecord write_listed(const TemporaryFolder& folder) {
  folder.put("a.csv", "1,2\n");
  folder.put("bag/b.mcap", "bag");
  FileRecord record{"run", "5e77", true, {}, hash_files(folder.path())};
  save_record(folder.path(), record);
  return record;
}

TEST(FindForeign, FindsNothingInWhatCastawayWrote) {
  const TemporaryFolder folder;
  const FileRecord record = write_listed(folder);
  fs::create_directories(folder.path() / "empty");
  EXPECT_FALSE(find_foreign(folder.path(), record));
}

TEST(FindForeign, FindsFilesOfOthers) {
  const TemporaryFolder folder;
  const FileRecord record = write_listed(folder);
  folder.put("bag/mine.txt", "mine");
  const ForeignFile foreign = find_foreign(folder.path(), record).value();
  EXPECT_EQ(foreign.path, "bag/mine.txt");
  EXPECT_FALSE(foreign.changed);
}

TEST(FindForeign, FindsFilesThatWereChanged) {
  const TemporaryFolder folder;
  const FileRecord record = write_listed(folder);
  folder.put("a.csv", "1,3\n");
  const ForeignFile foreign = find_foreign(folder.path(), record).value();
  EXPECT_EQ(foreign.path, "a.csv");
  EXPECT_TRUE(foreign.changed);
}

TEST(FindForeign, TakesALinkForAFileOfOthers) {
  const TemporaryFolder folder;
  const FileRecord record = write_listed(folder);
  fs::create_directory_symlink("/", folder.path() / "root");
  EXPECT_EQ(find_foreign(folder.path(), record).value().path, "root");
}

TEST(FindForeign, LeavesFoldersWithAListOfTheirOwnAside) {
  const TemporaryFolder folder;
  folder.put("seed-1/errors.csv", "");
  EXPECT_TRUE(find_foreign(folder.path(), std::nullopt));
  save_record(folder.path() / "seed-1", {});
  EXPECT_FALSE(find_foreign(folder.path(), std::nullopt));
}

/// A run of many seeds was killed when it began to write the list of a seed's folder.
TEST(FindForeign, TakesAHalfWrittenListInAFolderForOurs) {
  const TemporaryFolder folder;
  fs::create_directories(folder.path() / "seed-4");
  folder.put("seed-4/" + std::string(kRecordName) + ".part-28556", "{");
  EXPECT_FALSE(find_foreign(folder.path(), FileRecord{}));
  folder.put("seed-4/mine.part-28556", "mine");
  EXPECT_EQ(find_foreign(folder.path(), FileRecord{}).value().path, "seed-4/mine.part-28556");
}

/// A list from outside may name any file, so that only the list's own name is castaway's.
TEST(ClearLeftovers, RemovesHalfWrittenListsOnly) {
  const TemporaryFolder folder;
  const FileRecord record = write_listed(folder);
  folder.put("a.csv.part-12", "1,");
  folder.put(std::string(kRecordName) + ".part-7", "{");
  folder.put("mine.part-12", "mine");
  folder.put("a.csv.part-x", "mine");
  EXPECT_EQ(find_foreign(folder.path(), record).value().path, "a.csv.part-x");
  clear_leftovers(folder.path());
  EXPECT_TRUE(fs::exists(folder.path() / "a.csv.part-12"));
  EXPECT_FALSE(fs::exists(folder.path() / (std::string(kRecordName) + ".part-7")));
  EXPECT_TRUE(fs::exists(folder.path() / "mine.part-12"));
  EXPECT_TRUE(fs::exists(folder.path() / "a.csv.part-x"));
}

TEST(IsReplaceable, HoldsForFreePlacesAndUnchangedFiles) {
  const TemporaryFolder folder;
  const FileRecord record = write_listed(folder);
  EXPECT_TRUE(is_replaceable(folder.path(), "a.csv", record));
  EXPECT_TRUE(is_replaceable(folder.path(), "bag/b.mcap", record));
  EXPECT_TRUE(is_replaceable(folder.path(), "bag/new.mcap", record));
  EXPECT_TRUE(is_replaceable(folder.path(), "new/new.mcap", record));
}

TEST(IsReplaceable, DoesNotHoldForWhatOthersWrote) {
  const TemporaryFolder folder;
  const FileRecord record = write_listed(folder);
  folder.put("mine", "mine");
  folder.put("a.csv", "changed");
  fs::create_directory_symlink("/tmp", folder.path() / "link");
  EXPECT_FALSE(is_replaceable(folder.path(), "mine", record));
  EXPECT_FALSE(is_replaceable(folder.path(), "mine/b", record));
  EXPECT_FALSE(is_replaceable(folder.path(), "a.csv", record));
  EXPECT_FALSE(is_replaceable(folder.path(), "link/new", record));
  EXPECT_FALSE(is_replaceable(folder.path(), "bag/b.mcap", std::nullopt));
}

TEST(IsReplaceable, HoldsForEitherContentWhileAFileIsReplaced) {
  const TemporaryFolder folder;
  FileRecord record = write_listed(folder);
  record.coming["a.csv"] = sha256("new");
  EXPECT_TRUE(is_replaceable(folder.path(), "a.csv", record));
  folder.put("a.csv", "new");
  EXPECT_TRUE(is_replaceable(folder.path(), "a.csv", record));
  folder.put("a.csv", "mine");
  EXPECT_FALSE(is_replaceable(folder.path(), "a.csv", record));
}

TEST(IsReplaceable, NeedsAReportOfCastawayWhereTheListHasNoHash) {
  const TemporaryFolder folder;
  FileRecord record;
  record.files["report.html"] = "";
  folder.put("report.html", "my thesis");
  EXPECT_FALSE(is_replaceable(folder.path(), "report.html", record));
  folder.put("report.html", "<title>castaway: lab</title>");
  EXPECT_TRUE(is_replaceable(folder.path(), "report.html", record));
}

TEST(Settle, TakesInWhatArrived) {
  const TemporaryFolder folder;
  FileRecord record = write_listed(folder);
  record.coming = {{"a.csv", sha256("new")}, {"b.csv", sha256("b")}, {"c.csv", sha256("c")}};
  folder.put("a.csv", "new");
  folder.put("b.csv", "mine");
  const FileRecord settled = settle(folder.path(), record);
  EXPECT_TRUE(settled.coming.empty());
  EXPECT_EQ(settled.files.at("a.csv"), sha256("new"));
  EXPECT_EQ(settled.files.at("bag/b.mcap"), sha256("bag"));
  EXPECT_EQ(settled.files.size(), 2U);
}

}  // namespace
}  // namespace castaway::testbed
