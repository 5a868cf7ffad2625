#include "tools/output/file_record.hpp"

#include <gtest/gtest.h>

#include "tests/tools/support/temporary.hpp"
#include "tools/files/file.hpp"

namespace castaway::testbed {
namespace {

namespace fs = std::filesystem;

/// Writes a folder with two files of castaway.
FileRecord write_two(const TemporaryFolder& folder) {
  folder.put("a.csv", "1,2\n");
  folder.put("bag/b.mcap", "bag");
  FileRecord record{"run", "5e77", true, {}, hash_files(folder.path())};
  save_record(folder.path(), record);
  return record;
}

TEST(FileRecord, ReadsBackAsItWasSaved) {
  const TemporaryFolder folder;
  FileRecord record = write_two(folder);
  record.finished = false;
  record.program = "abc";
  record.single_files["kidnap.mp4"] = "12";
  record.runs = {"seed-1", "seed-2"};
  save_record(folder.path(), record);
  const FileRecord again = load_record(folder.path()).value();
  EXPECT_EQ(again.made_by, "run");
  EXPECT_EQ(again.settings, "5e77");
  EXPECT_FALSE(again.finished);
  EXPECT_EQ(again.program, "abc");
  EXPECT_EQ(again.files, record.files);
  EXPECT_EQ(again.single_files, record.single_files);
  EXPECT_EQ(again.runs, record.runs);
}

TEST(FileRecord, GivesNoHashToClockReadings) {
  const TemporaryFolder folder;
  folder.put("timing.json", "{}");
  folder.put("summary.json", "{}");
  EXPECT_EQ(hash_file(folder.path(), "timing.json"), "");
  EXPECT_EQ(hash_file(folder.path(), "summary.json").size(), 64U);
}

TEST(FileRecord, IsNothingWhereThereIsNone) {
  const TemporaryFolder folder;
  EXPECT_FALSE(load_record(folder.path()));
}

TEST(FileRecord, RefusesAFileThatIsNoList) {
  const TemporaryFolder folder;
  for (const char* text : {"", "[]", "{}", "{\"castaway\": \"1\", \"files\": 3}", "\x01\x02"}) {
    folder.put(kRecordName, text);
    EXPECT_TRUE(contains(error_of([&] { static_cast<void>(load_record(folder.path())); }),
                         "is not castaway's list"));
  }
}

TEST(FindForeign, FindsNothingInWhatCastawayWrote) {
  const TemporaryFolder folder;
  const FileRecord record = write_two(folder);
  fs::create_directories(folder.path() / "empty");
  EXPECT_FALSE(find_foreign(folder.path(), record));
}

TEST(FindForeign, FindsFilesOfOthers) {
  const TemporaryFolder folder;
  const FileRecord record = write_two(folder);
  folder.put("bag/mine.txt", "mine");
  const ForeignFile foreign = find_foreign(folder.path(), record).value();
  EXPECT_EQ(foreign.path, "bag/mine.txt");
  EXPECT_FALSE(foreign.changed);
}

TEST(FindForeign, FindsFilesThatWereChanged) {
  const TemporaryFolder folder;
  const FileRecord record = write_two(folder);
  folder.put("a.csv", "1,3\n");
  const ForeignFile foreign = find_foreign(folder.path(), record).value();
  EXPECT_EQ(foreign.path, "a.csv");
  EXPECT_TRUE(foreign.changed);
}

TEST(FindForeign, TakesALinkForAFileOfOthers) {
  const TemporaryFolder folder;
  const FileRecord record = write_two(folder);
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

TEST(ClearLeftovers, RemovesHalfWrittenFilesOfTheListOnly) {
  const TemporaryFolder folder;
  const FileRecord record = write_two(folder);
  folder.put("a.csv.part-12", "1,");
  folder.put(std::string(kRecordName) + ".part-7", "{");
  folder.put("mine.part-12", "mine");
  folder.put("a.csv.part-x", "mine");
  EXPECT_EQ(find_foreign(folder.path(), record).value().path, "a.csv.part-x");
  clear_leftovers(folder.path(), record);
  EXPECT_FALSE(fs::exists(folder.path() / "a.csv.part-12"));
  EXPECT_FALSE(fs::exists(folder.path() / (std::string(kRecordName) + ".part-7")));
  EXPECT_TRUE(fs::exists(folder.path() / "mine.part-12"));
  EXPECT_TRUE(fs::exists(folder.path() / "a.csv.part-x"));
}

TEST(IsReplaceable, HoldsForFreePlacesAndUnchangedFiles) {
  const TemporaryFolder folder;
  const FileRecord record = write_two(folder);
  EXPECT_TRUE(is_replaceable(folder.path(), "a.csv", record));
  EXPECT_TRUE(is_replaceable(folder.path(), "bag/b.mcap", record));
  EXPECT_TRUE(is_replaceable(folder.path(), "bag/new.mcap", record));
  EXPECT_TRUE(is_replaceable(folder.path(), "new/new.mcap", record));
}

TEST(IsReplaceable, DoesNotHoldForWhatOthersWrote) {
  const TemporaryFolder folder;
  const FileRecord record = write_two(folder);
  folder.put("mine", "mine");
  folder.put("a.csv", "changed");
  fs::create_directory_symlink("/tmp", folder.path() / "link");
  EXPECT_FALSE(is_replaceable(folder.path(), "mine", record));
  EXPECT_FALSE(is_replaceable(folder.path(), "mine/b", record));
  EXPECT_FALSE(is_replaceable(folder.path(), "a.csv", record));
  EXPECT_FALSE(is_replaceable(folder.path(), "link/new", record));
  EXPECT_FALSE(is_replaceable(folder.path(), "bag/b.mcap", std::nullopt));
}

}  // namespace
}  // namespace castaway::testbed
