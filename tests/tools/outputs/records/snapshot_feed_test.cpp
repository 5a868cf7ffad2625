#include "tools/outputs/records/snapshot_feed.hpp"

#include <gtest/gtest.h>

#include "tests/tools/support/temporary.hpp"

namespace castaway::testbed {
namespace {

TEST(SnapshotFeed, IsEmptyWithoutPictures) {
  const TemporaryFolder folder;
  EXPECT_TRUE(SnapshotFeed(folder.path()).take_new().empty());
}

TEST(SnapshotFeed, GivesEachPictureOnceByName) {
  const TemporaryFolder folder;
  SnapshotFeed feed(folder.path());
  folder.put("snapshots/t0012.500-kidnap-1-map.png", "b");
  folder.put("snapshots/t0012.500-kidnap-1-chase.png", "a");
  folder.put("snapshots/none.txt", "why");
  folder.put("snapshots/other.png", "c");
  const auto first = feed.take_new();
  ASSERT_EQ(first.size(), 2U);
  EXPECT_EQ(first[0].view, "chase");
  EXPECT_EQ(first[0].png, "a");
  EXPECT_EQ(first[1].view, "map");
  EXPECT_EQ(first[1].stamp, std::chrono::milliseconds(12'500));
  folder.put("snapshots/t0020.000-recovery-1-map.png", "d");
  const auto second = feed.take_new();
  ASSERT_EQ(second.size(), 1U);
  EXPECT_EQ(second[0].png, "d");
}

}  // namespace
}  // namespace castaway::testbed
