#include "tools/batch/dataset/dataset_splits.hpp"

#include <algorithm>
#include <map>
#include <set>

#include <gtest/gtest.h>

#include "tests/tools/support/temporary.hpp"

namespace castaway::testbed {
namespace {

using Worlds = std::vector<std::string>;

/// `count` worlds with `each` sequences, interleaved.
Worlds worlds_of(int count, int each) {
  Worlds worlds;
  for (int i = 0; i < count * each; ++i) worlds.push_back("world-" + std::to_string(i % count));
  return worlds;
}

std::map<int, int> sizes(const DatasetSplits& splits) {
  std::map<int, int> count;
  for (const int part : splits.part) ++count[part];
  return count;
}

TEST(DatasetSplits, NoWorldIsInTwoParts) {
  const Worlds worlds = worlds_of(10, 7);
  const DatasetSplits splits = split_dataset(worlds, {}, 1);
  std::map<std::string, std::set<int>> parts;
  for (std::size_t i = 0; i < worlds.size(); ++i) parts[worlds[i]].insert(splits.part[i]);
  for (const auto& [world, in] : parts) EXPECT_EQ(in.size(), 1U) << world;
  EXPECT_EQ(sizes(splits), (std::map<int, int>{{0, 56}, {1, 7}, {2, 7}}));
  EXPECT_EQ(splits.remark, "");
}

TEST(DatasetSplits, EveryPartHasAWorldBeforeOneHasTwo) {
  EXPECT_EQ(sizes(split_dataset(worlds_of(3, 5), {}, 1)),
            (std::map<int, int>{{0, 5}, {1, 5}, {2, 5}}));
}

TEST(DatasetSplits, TheLargestWorldIsToLearnFrom) {
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    const DatasetSplits splits = split_dataset({"a", "b", "b", "b", "c"}, {}, seed);
    EXPECT_EQ(splits.part[1], 0);
    EXPECT_EQ(sizes(splits), (std::map<int, int>{{0, 3}, {1, 1}, {2, 1}}));
  }
}

TEST(DatasetSplits, TooFewWorldsAreSaid) {
  const DatasetSplits one = split_dataset(worlds_of(1, 4), {}, 1);
  EXPECT_EQ(sizes(one), (std::map<int, int>{{0, 4}}));
  EXPECT_EQ(one.remark,
            "1 world for 3 splits: test and val are empty; add worlds, or set splits: {by: "
            "sequence}");
  const DatasetSplits two = split_dataset(worlds_of(2, 4), {}, 1);
  EXPECT_EQ(sizes(two), (std::map<int, int>{{0, 4}, {2, 4}}));
  EXPECT_TRUE(contains(two.remark, "2 worlds for 3 splits: val is empty"));
  SplitSpec no_val;
  no_val.val = 0.0;
  EXPECT_EQ(split_dataset(worlds_of(2, 4), no_val, 1).remark, "");
}

TEST(DatasetSplits, BySequenceKeepToTheShares) {
  SplitSpec spec;
  spec.by_sequence = true;
  const DatasetSplits splits = split_dataset(worlds_of(1, 20), spec, 1);
  EXPECT_EQ(sizes(splits), (std::map<int, int>{{0, 16}, {1, 2}, {2, 2}}));
  EXPECT_FALSE(std::is_sorted(splits.part.begin(), splits.part.end()));
  EXPECT_NE(splits.part, split_dataset(worlds_of(1, 20), spec, 2).part);
}

}  // namespace
}  // namespace castaway::testbed
