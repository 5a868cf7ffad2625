#include "tools/scenario/files/bag_folder.hpp"

#include <gtest/gtest.h>

#include "tests/tools/support/temporary.hpp"

namespace castaway::testbed {
namespace {

using Paths = std::vector<std::filesystem::path>;

std::string metadata(const std::string& storage, const std::string& files) {
  return "rosbag2_bagfile_information:\n  version: 9\n  storage_identifier: " + storage +
         "\n  relative_file_paths: [" + files + "]\n";
}

TEST(BagFolder, TellsABagFromALog) {
  const TemporaryFolder folder;
  EXPECT_TRUE(is_bag(folder.path()));
  EXPECT_TRUE(is_bag("a.mcap"));
  EXPECT_TRUE(is_bag("a.db3"));
  EXPECT_TRUE(is_bag("a.bag"));
  EXPECT_FALSE(is_bag("log.carmen.gz"));
}

TEST(BagFolder, TakesTheFilesOfTheMetadataInTheirOrder) {
  const TemporaryFolder folder;
  for (const char* name : {"b.mcap", "a.mcap", "c.mcap"}) folder.put(name, "");
  folder.put("metadata.yaml", metadata("mcap", "b.mcap, a.mcap"));
  EXPECT_EQ(bag_files(folder.path()), (Paths{folder.path() / "b.mcap", folder.path() / "a.mcap"}));
}

TEST(BagFolder, DoesWithoutMetadata) {
  const TemporaryFolder folder;
  for (const char* name : {"b.mcap", "a.mcap", "note.txt"}) folder.put(name, "");
  EXPECT_EQ(bag_files(folder.path()), (Paths{folder.path() / "a.mcap", folder.path() / "b.mcap"}));
}

TEST(BagFolder, FindsTheBagOfARun) {
  const TemporaryFolder folder;
  folder.put("bag/a.mcap", "");
  EXPECT_EQ(bag_files(folder.path()), (Paths{folder.path() / "bag" / "a.mcap"}));
}

TEST(BagFolder, TakesFilesOfSqlite3) {
  const TemporaryFolder folder;
  folder.put("s/a.db3", "");
  EXPECT_EQ(bag_files(folder.path() / "s"), (Paths{folder.path() / "s" / "a.db3"}));
  folder.put("s/metadata.yaml", metadata("sqlite3", "a.db3"));
  EXPECT_EQ(bag_files(folder.path() / "s"), (Paths{folder.path() / "s" / "a.db3"}));
}

TEST(BagFolder, NamesTheRemedyForOtherKinds) {
  const TemporaryFolder folder;
  const auto refusal = [](const std::filesystem::path& path) {
    return error_of([&] { bag_files(path); });
  };
  EXPECT_TRUE(contains(refusal("old.bag"), "old.bag: is a bag of ROS 1"));
  folder.put("z/a.mcap.zstd", "");
  folder.put("z/metadata.yaml", metadata("mcap", "a.mcap.zstd"));
  EXPECT_TRUE(contains(refusal(folder.path() / "z"), "zstd -d"));
  folder.put("m/metadata.yaml", metadata("mcap", "gone.mcap"));
  EXPECT_TRUE(contains(refusal(folder.path() / "m"), "gone.mcap: cannot be read"));
  std::filesystem::create_directories(folder.path() / "e");
  EXPECT_TRUE(contains(refusal(folder.path() / "e"), "holds no .mcap or .db3 file"));
  EXPECT_TRUE(contains(refusal(folder.path() / "none.mcap"), "cannot be read"));
}

}  // namespace
}  // namespace castaway::testbed
