#include "tools/base/output/file_record.hpp"

#include <gtest/gtest.h>

#include "tests/tools/support/temporary.hpp"
#include "tools/base/bytes/sha256.hpp"

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
  record.single_files["kidnap.mp4"] = sha256("film");
  record.coming["a.csv"] = sha256("3,4\n");
  record.runs = {"seed-1", "seed-2"};
  save_record(folder.path(), record);
  const FileRecord again = load_record(folder.path()).value();
  EXPECT_EQ(again.made_by, "run");
  EXPECT_EQ(again.settings, "5e77");
  EXPECT_FALSE(again.finished);
  EXPECT_EQ(again.program, "abc");
  EXPECT_EQ(again.files, record.files);
  EXPECT_EQ(again.single_files, record.single_files);
  EXPECT_EQ(again.coming, record.coming);
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

/// Whoever ships a folder may have written its list.
TEST(FileRecord, RefusesPathsThatLeadOutOfItsFolder) {
  const TemporaryFolder folder;
  const std::string hash = sha256("x");
  for (const char* path : {"../a", "/a", "a/../../b", "", ".", "a//b"}) {
    for (const char* key : {"files", "single_files", "coming"}) {
      folder.put(kRecordName, R"({"castaway": "1", ")" + std::string(key) + R"(": {")" + path +
                                  R"(": ")" + hash + R"("}})");
      EXPECT_TRUE(contains(error_of([&] { static_cast<void>(load_record(folder.path())); }),
                           "lists the path '" + std::string(path) + "'"));
    }
    folder.put(kRecordName, R"({"castaway": "1", "runs": [")" + std::string(path) + R"("]})");
    EXPECT_TRUE(contains(error_of([&] { static_cast<void>(load_record(folder.path())); }),
                         "lists the path '" + std::string(path) + "'"));
  }
}

TEST(FileRecord, RefusesFilesWithoutAHashThatHoldNoClockReadings) {
  const TemporaryFolder folder;
  for (const char* entry :
       {R"("thesis.tex": null)", R"("a/report.html": null)", R"("a": "12")", R"("a": 7)"}) {
    folder.put(kRecordName, R"({"castaway": "1", "files": {)" + std::string(entry) + "}}");
    EXPECT_TRUE(contains(error_of([&] { static_cast<void>(load_record(folder.path())); }),
                         "is not castaway's list"))
        << entry;
  }
  folder.put(kRecordName, R"({"castaway": "1", "files": {"report.html": null}})");
  EXPECT_EQ(load_record(folder.path()).value().files.size(), 1U);
}

TEST(FileRecord, RefusesALink) {
  const TemporaryFolder folder;
  folder.put("list", R"({"castaway": "1"})");
  std::filesystem::create_symlink("list", folder.path() / kRecordName);
  EXPECT_TRUE(
      contains(error_of([&] { static_cast<void>(load_record(folder.path())); }), "is a link"));
}

}  // namespace
}  // namespace castaway::testbed
