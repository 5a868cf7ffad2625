#include "tools/base/output/work_folder.hpp"

#include <gtest/gtest.h>

#include "tests/tools/support/temporary.hpp"
#include "tools/base/files/file.hpp"

namespace castaway::testbed {
namespace {

namespace fs = std::filesystem;

const FileRecord kFirstList{"run", "5e77", false, {}, {}};

void write_new_draft(const fs::path& draft) { write_file(draft, "new"); }

TEST(WorkFolder, LeavesNothingWhereNothingCame) {
  const TemporaryFolder folder;
  {
    WorkFolder work(folder.path());
    work.begin(kFirstList);
    EXPECT_EQ(load_record(folder.path()).value().made_by, "run");
    write_file(work.drafts() / "a", "half");
  }
  EXPECT_TRUE(fs::is_empty(folder.path()));
}

TEST(WorkFolder, PutsAFileAndListsItAsComingFirst) {
  const TemporaryFolder folder;
  {
    WorkFolder work(folder.path());
    work.begin(kFirstList);
    const std::string hash = work.put("a", write_new_draft);
    EXPECT_EQ(load_record(folder.path()).value().coming, (FileHashes{{"a", hash}}));
    EXPECT_TRUE(work.record().coming.empty());
  }
  EXPECT_EQ(read_file(folder.path() / "a"), "new");
  EXPECT_FALSE(fs::exists(folder.path() / kStagingName));
  WorkFolder again(folder.path());  // The process ended before it saved the list.
  EXPECT_TRUE(again.record().files.contains("a"));
}

TEST(WorkFolder, MovesDraftsInSubfolders) {
  const TemporaryFolder folder;
  WorkFolder work(folder.path());
  work.begin(kFirstList);
  write_file(work.drafts() / "bag/x.mcap", "x");
  work.move_in(hash_files(work.drafts()));
  EXPECT_EQ(read_file(folder.path() / "bag/x.mcap"), "x");
}

TEST(WorkFolder, KeepsTheListOfAnEarlierProcess) {
  const TemporaryFolder folder;
  save_record(folder.path(), {"run", "first", true, {}, {}});
  {
    WorkFolder work(folder.path());
    work.begin({"run", "second", false, {}, {}});
  }
  EXPECT_EQ(load_record(folder.path()).value().settings, "first");
}

TEST(WorkFolder, ReplacesNoFileOfOthers) {
  const TemporaryFolder folder;
  folder.put("mine", "mine");
  folder.put(".castaway.json.part-1", "half");
  WorkFolder work(folder.path());
  EXPECT_FALSE(fs::exists(folder.path() / ".castaway.json.part-1"));
  EXPECT_NO_THROW(work.require_replaceable({{"other", ""}}));
  EXPECT_TRUE(contains(error_of([&] { work.put("mine", write_new_draft); }),
                       "mine: castaway did not write what is there"));
  EXPECT_EQ(read_file(folder.path() / "mine"), "mine");
}

TEST(WorkFolder, KeepsDraftsOfOthers) {
  const TemporaryFolder folder;
  folder.put(".castaway-unfinished/mine", "mine");
  EXPECT_TRUE(
      contains(error_of([&] { WorkFolder work(folder.path()); }), "castaway did not make it"));
  EXPECT_EQ(read_file(folder.path() / ".castaway-unfinished/mine"), "mine");
}

TEST(WorkFolder, IsHeldByOneProcess) {
  const TemporaryFolder folder;
  const WorkFolder work(folder.path());
  EXPECT_TRUE(contains(error_of([&] { WorkFolder second(folder.path()); }), "another castaway"));
}

}  // namespace
}  // namespace castaway::testbed
