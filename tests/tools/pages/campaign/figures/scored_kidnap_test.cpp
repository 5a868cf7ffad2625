#include "tools/pages/campaign/figures/scored_kidnap.hpp"

#include <gtest/gtest.h>

#include "tests/tools/support/campaign_rows.hpp"

namespace castaway::testbed {
namespace {

TEST(ScoredKidnap, IsLostUntilItsRecoveryTheNextKidnapOrTheEnd) {
  CellRow row;
  row.metrics["duration_s"] = 20.0;
  row.kidnaps = {kidnap_of("a", 2.0, 1.5), kidnap_of("b", 2.0, std::nullopt),
                 kidnap_of("a", 6.0, std::nullopt), kidnap_of("b", 6.0, std::nullopt),
                 kidnap_of("a", 13.0, std::nullopt)};
  const auto kidnaps = scored_kidnaps(row, "a");
  ASSERT_EQ(kidnaps.size(), 3U);
  EXPECT_EQ(kidnaps[0].lost_s, 1.5);
  EXPECT_EQ(kidnaps[1].lost_s, 7.0);
  EXPECT_EQ(kidnaps[2].lost_s, 7.0);
  EXPECT_EQ(scored_kidnaps(row, "b")[1].lost_s, 14.0);
}

TEST(ScoredKidnap, CountsThoseThatAreNotScored) {
  CellRow row;
  row.kidnaps = {kidnap_of("a", 2.0, std::nullopt), kidnap_of("a", 4.0, 1.0)};
  row.kidnaps[0].scored = false;
  const auto kidnaps = scored_kidnaps(row, "a");
  ASSERT_EQ(kidnaps.size(), 1U);
  EXPECT_EQ(kidnaps[0].number, 1);
}

TEST(ScoredKidnap, OfARowWithoutDurationIsNotLostForLessThanNothing) {
  CellRow row;
  row.kidnaps = {kidnap_of("a", 2.0, std::nullopt)};
  EXPECT_EQ(scored_kidnaps(row, "a")[0].lost_s, 0.0);
  EXPECT_TRUE(scored_kidnaps(row, "c").empty());
}

}  // namespace
}  // namespace castaway::testbed
