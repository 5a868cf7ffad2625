#include "tools/batch/dataset/dataset_folder.hpp"

#include <chrono>
#include <thread>

#include <gtest/gtest.h>

#include "tests/tools/support/temporary.hpp"
#include "tools/base/bytes/sha256.hpp"
#include "tools/base/files/file.hpp"
#include "tools/base/output/file_record.hpp"
#include "tools/batch/dataset/dataset_manifest.hpp"

namespace castaway::testbed {
namespace {

namespace fs = std::filesystem;

DatasetIdentity identity() { return {"1.0", 7, 3, "name: a\nvary:\n  x: 1\n"}; }

std::string refusal(const fs::path& folder, const DatasetIdentity& other) {
  return error_of([&] { DatasetFolder(folder, other); });
}

TEST(DatasetFolder, KeepsFinishedSequencesAndClearsTheRest) {
  const TemporaryFolder temporary;
  const fs::path path = temporary.path() / "set";
  {
    DatasetFolder folder(path, identity());
    fs::create_directories(folder.draft("000000"));
    write_file(folder.draft("000000") / "a", "a");
    folder.commit_sequence("000000");
    fs::create_directories(folder.draft("000001"));
    write_file(folder.draft("000001") / "half", "h");
  }
  const DatasetFolder again(path, identity());
  EXPECT_TRUE(again.has_sequence("000000"));
  EXPECT_FALSE(again.has_sequence("000001"));
  EXPECT_FALSE(fs::exists(again.draft("000001")));
  EXPECT_EQ(read_file(again.sequence("000000") / "a"), "a");
  EXPECT_EQ(read_file(path / "dataset.yaml"), identity().spec);
  EXPECT_FALSE(again.is_finished());
}

TEST(DatasetFolder, IsSharedByShards) {
  const TemporaryFolder temporary;
  const fs::path path = temporary.path() / "set";
  {
    const DatasetFolder first(path, identity(), {1, 2});
    const DatasetFolder second(path, identity(), {2, 2});
    EXPECT_TRUE(contains(error_of([&] { DatasetFolder(path, identity(), {2, 2}); }), "another"));
    EXPECT_TRUE(contains(refusal(path, identity()), "another castaway process"));
    for (const DatasetFolder* folder : {&first, &second}) {
      const std::string name = folder == &first ? "000000" : "000001";
      fs::create_directories(folder->draft(name));
      write_file(folder->draft(name) / "a", name);
      folder->commit_sequence(name);
      fs::create_directories(folder->draft("half"));
    }
  }
  const DatasetFolder again(path, identity(), {2, 2});
  EXPECT_FALSE(fs::exists(again.draft("half")));
  EXPECT_TRUE(fs::exists(path / ".work-1-of-2/half"));
  again.clear_work();
  const DatasetFolder whole(path, identity());
  EXPECT_TRUE(whole.has_sequence("000000") && whole.has_sequence("000001"));
  EXPECT_FALSE(fs::exists(path / ".work-1-of-2"));
}

TEST(DatasetFolder, LeavesNothingButWhatBelongsToIt) {
  const TemporaryFolder temporary;
  const DatasetFolder folder(temporary.path() / "set", identity());
  folder.put("plots/a.svg", "<svg/>");
  folder.put("manifest.json", "{}");
  folder.clear_work();
  EXPECT_TRUE(folder.is_finished());
  EXPECT_EQ(read_file(folder.path() / "plots/a.svg"), "<svg/>");
  EXPECT_FALSE(fs::exists(folder.path() / ".work"));
}

TEST(DatasetFolder, MayGrow) {
  const TemporaryFolder temporary;
  const fs::path path = temporary.path() / "set";
  DatasetFolder(path, identity()).put("manifest.json", manifest_text({}));
  DatasetIdentity more = identity();
  more.sequences = 5;
  EXPECT_FALSE(DatasetFolder(path, more).is_finished());
  EXPECT_TRUE(contains(refusal(path, identity()), "has 5 sequences, more than 3"));
}

TEST(DatasetFolder, KeepsToOneIdentity) {
  const TemporaryFolder temporary;
  const fs::path path = temporary.path() / "set";
  { const DatasetFolder folder(path, identity()); }
  DatasetIdentity other = identity();
  other.version = "2.0";
  EXPECT_TRUE(contains(refusal(path, other), "was made by castaway 1.0, this is 2.0"));
  other = identity();
  other.seed = 8;
  EXPECT_TRUE(contains(refusal(path, other), "was made with seed 7, not 8"));
  other = identity();
  other.spec = "name: a\nvary:\n  x: 2\n";
  EXPECT_TRUE(contains(refusal(path, other),
                       "line 3 of its dataset.yaml is 'x: 1', now it would be 'x: 2'"));
  other.spec = "name: a\n";
  EXPECT_TRUE(contains(refusal(path, other),
                       "line 2 of its dataset.yaml is 'vary:', now it would "
                       "be nothing"));
}

/// A process that waits for the folder must not take what was begun there for its own.
TEST(DatasetFolder, KeepsWhatAnotherProcessBeganInTheMeantime) {
  const TemporaryFolder temporary;
  const fs::path path = temporary.path() / "set";
  DatasetIdentity other = identity();
  other.seed = 8;
  std::string said;
  std::thread waiting;
  {
    const DatasetFolder folder(temporary.path() / "another", identity());
    fs::create_directories(path);
    const FolderLock lock(path);
    waiting = std::thread([&] { said = refusal(path, other); });
    std::this_thread::sleep_for(std::chrono::milliseconds(300));
    for (const char* name : {"dataset.yaml", "dataset.json"}) {
      fs::copy(folder.path() / name, path / name);
    }
  }
  waiting.join();
  EXPECT_TRUE(contains(said, "was made with seed 7, not 8"));
}

TEST(DatasetFolder, TouchesNoFolderOfOthers) {
  const TemporaryFolder temporary;
  temporary.put("set/thesis.tex", "");
  EXPECT_TRUE(contains(refusal(temporary.path() / "set", identity()),
                       "holds 'thesis.tex' and no data set; choose another folder"));
  temporary.put("file", "");
  EXPECT_TRUE(contains(refusal(temporary.path() / "file", identity()), "is no folder"));
}

TEST(DatasetFolder, TakesNoFileOfOthersForItsOwn) {
  const TemporaryFolder temporary;
  const fs::path path = temporary.path() / "set";
  temporary.put("set/dataset.yaml", "mine");
  save_record(path, {"dataset", {}, false, {}, {}});
  EXPECT_TRUE(contains(refusal(path, identity()), "holds 'dataset.yaml' and no data set"));
  fs::remove_all(path);
  const DatasetFolder folder(path, identity());
  temporary.put("set/README.md", "mine");
  EXPECT_TRUE(contains(error_of([&] { folder.put_new("README.md", "card"); }), "did not write"));
  EXPECT_NO_THROW(folder.put_new("README.md", "mine"));
  EXPECT_EQ(read_file(path / "README.md"), "mine");
}

TEST(DatasetFolder, WritesThroughNoLink) {
  const TemporaryFolder temporary;
  const fs::path path = temporary.path() / "set";
  { const DatasetFolder folder(path, identity()); }
  fs::create_directories(temporary.path() / "mine");
  fs::create_directory_symlink("../mine", path / "maps");
  {
    const DatasetFolder folder(path, identity());
    EXPECT_TRUE(contains(error_of([&] { folder.put("maps/a.pgm", "x"); }), "is a link"));
  }
  fs::remove_all(path / "sequences");
  fs::create_directory_symlink("../mine", path / "sequences");
  EXPECT_TRUE(contains(refusal(path, identity()), "sequences: is a link"));
  EXPECT_TRUE(fs::is_empty(temporary.path() / "mine"));
}

TEST(DatasetFolder, RemovesItsTablesBeforeItGrows) {
  const TemporaryFolder temporary;
  const fs::path path = temporary.path() / "set";
  const std::vector<ManifestFile> listed{{"README.md", 4, sha256("card")}};
  {
    const DatasetFolder folder(path, identity());
    folder.put("README.md", "card");
    folder.put("SHA256SUMS", sums_text(listed));
    folder.put("manifest.json", manifest_text(listed));
  }
  temporary.put("set/notes.txt", "mine");
  DatasetIdentity more = identity();
  more.sequences = 5;
  const DatasetFolder folder(path, more);
  EXPECT_FALSE(fs::exists(path / "README.md"));
  EXPECT_FALSE(fs::exists(path / "SHA256SUMS"));
  EXPECT_EQ(read_file(path / "notes.txt"), "mine");
}

TEST(DatasetFolder, ABeginningThatWasKilledIsGoneOnWith) {
  const TemporaryFolder temporary;
  temporary.put("set/dataset.yaml", "of another specification");
  FileRecord record{"dataset", {}, false, {}, {}};
  record.files["dataset.yaml"] = hash_file(temporary.path() / "set", "dataset.yaml");
  save_record(temporary.path() / "set", record);
  temporary.put("set/.work/file.part-1", "x");
  const DatasetFolder folder(temporary.path() / "set", identity());
  EXPECT_EQ(read_file(folder.path() / "dataset.yaml"), identity().spec);
}

}  // namespace
}  // namespace castaway::testbed
