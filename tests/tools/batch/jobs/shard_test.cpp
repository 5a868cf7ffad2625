#include "tools/batch/jobs/shard.hpp"

#include <gtest/gtest.h>

#include "tests/tools/support/temporary.hpp"

namespace castaway::testbed {
namespace {

TEST(Shard, EveryJobIsMadeByOneOfThem) {
  for (int job = 0; job < 20; ++job) {
    int makers = 0;
    for (int index = 1; index <= 3; ++index) makers += Shard{index, 3}.makes(job) ? 1 : 0;
    EXPECT_EQ(makers, 1) << job;
  }
  EXPECT_TRUE((Shard{2, 3}.makes(1)));
  EXPECT_TRUE(Shard{}.is_all());
}

TEST(Shard, NumbersItsJobs) {
  const Shard shard{2, 3};
  for (int k = 0; k < 4; ++k) EXPECT_TRUE(shard.makes(shard.job(k))) << k;
  EXPECT_EQ(shard.job(0), 1);
  EXPECT_EQ(shard.job(2), 7);
  EXPECT_EQ(Shard{}.job(5), 5);
}

TEST(Shard, AreThoseThatMakeTheJobs) {
  EXPECT_EQ(shards_of({7, 1, 4, 5}, 3), (std::vector<int>{2, 3}));
  EXPECT_TRUE(shards_of({}, 3).empty());
}

TEST(Shard, IsParsedFromItsPlaceAndTheirNumber) {
  const Shard shard = parse_shard("3/8");
  EXPECT_EQ(shard.index, 3);
  EXPECT_EQ(shard.count, 8);
  EXPECT_FALSE(shard.is_all());
  for (const char* text : {"", "3", "0/8", "9/8", "3/", "/8", "a/8", "3/8x", "1/100001", "-1/8"}) {
    EXPECT_TRUE(contains(error_of([&] { parse_shard(text); }), "--shard needs I/N")) << text;
  }
}

}  // namespace
}  // namespace castaway::testbed
