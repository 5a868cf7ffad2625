#include "tools/base/output/own_file.hpp"

#include <gtest/gtest.h>

#include "tests/tools/support/temporary.hpp"
#include "tools/base/files/file.hpp"
#include "tools/base/output/file_record.hpp"

namespace castaway::testbed {
namespace {

namespace fs = std::filesystem;

TEST(OwnFile, IsReplacedBySecondCall) {
  const TemporaryFolder folder;
  write_own_file(folder.path() / "new/junit.xml", "1");
  write_own_file(folder.path() / "new/junit.xml", "2");
  EXPECT_EQ(read_file(folder.path() / "new/junit.xml"), "2");
}

TEST(OwnFile, NeverReplacesAFileOfOthers) {
  const TemporaryFolder folder;
  folder.put("map.yaml", "mine");
  EXPECT_TRUE(contains(error_of([&] { write_own_file(folder.path() / "map.yaml", "x"); }),
                       "map.yaml: exists, and castaway did not write it"));
  EXPECT_EQ(read_file(folder.path() / "map.yaml"), "mine");
}

TEST(OwnFile, NeverReplacesOneThatWasChangedSince) {
  const TemporaryFolder folder;
  write_own_file(folder.path() / "map.yaml", "ours");
  folder.put("map.yaml", "edited");
  EXPECT_TRUE(contains(error_of([&] { require_own_file(folder.path() / "map.yaml"); }), "exists"));
  EXPECT_EQ(read_file(folder.path() / "map.yaml"), "edited");
}

TEST(OwnFile, NeverReplacesADevice) {
  EXPECT_TRUE(contains(error_of([] { require_own_file("/dev/null"); }), "/dev/null: exists"));
}

TEST(OwnFile, NeedsAName) {
  const TemporaryFolder folder;
  EXPECT_TRUE(
      contains(error_of([&] { require_own_file(folder.path() / "sub/"); }), "names a folder"));
}

TEST(OwnFile, ThatCannotBeWrittenLeavesNothing) {
  const TemporaryFolder folder;
  const auto fail = [](const fs::path&) { throw std::runtime_error("no picture"); };
  EXPECT_EQ(error_of([&] { put_own_file(folder.path() / "map.png", fail); }), "no picture");
  EXPECT_TRUE(fs::is_empty(folder.path()));
}

TEST(OwnFile, GoesOnAfterAProcessThatWasKilledOnTheWay) {
  const TemporaryFolder folder;
  write_own_file(folder.path() / "map.yaml", "old");
  FileRecord record = load_record(folder.path()).value();
  record.coming["map.yaml"] = record.single_files.at("map.yaml");
  record.single_files.clear();  // It came, and the list was not yet told.
  save_record(folder.path(), record);
  folder.put(".castaway-unfinished/map.yaml", "half");
  write_own_file(folder.path() / "map.yaml", "new");
  EXPECT_EQ(read_file(folder.path() / "map.yaml"), "new");
  EXPECT_FALSE(fs::exists(folder.path() / ".castaway-unfinished"));
  EXPECT_TRUE(load_record(folder.path()).value().coming.empty());
  EXPECT_TRUE(load_record(folder.path()).value().single_files.contains("map.yaml"));
}

TEST(OwnFile, NeverClearsAFolderOfDraftsOfOthers) {
  const TemporaryFolder folder;
  folder.put(".castaway-unfinished/mine", "mine");
  EXPECT_TRUE(contains(error_of([&] { write_own_file(folder.path() / "map.yaml", "x"); }),
                       "castaway did not make it"));
  EXPECT_EQ(read_file(folder.path() / ".castaway-unfinished/mine"), "mine");
}

TEST(OwnFile, MayReplaceAFileOfARun) {
  const TemporaryFolder folder;
  folder.put("report.html", "<title>castaway: old</title>");
  FileRecord record{"run", "5e77", true, {}, {{"report.html", ""}}};
  save_record(folder.path(), record);
  write_own_file(folder.path() / "report.html", "new");
  EXPECT_EQ(read_file(folder.path() / "report.html"), "new");
  EXPECT_TRUE(load_record(folder.path()).value().files.contains("report.html"));
  EXPECT_TRUE(load_record(folder.path()).value().single_files.empty());
}

}  // namespace
}  // namespace castaway::testbed
