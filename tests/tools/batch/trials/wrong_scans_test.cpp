#include "tools/batch/trials/wrong_scans.hpp"

#include <gtest/gtest.h>

#include "tests/tools/support/metric_rows.hpp"

namespace castaway::testbed {
namespace {

WrongScans since(double begin_s, const std::vector<MetricRow>& rows) {
  return wrong_scans_since(from_seconds(begin_s), rows, from_seconds(10.0), {});
}

TEST(WrongScans, AreThoseWithoutTheAlarm) {
  std::vector<MetricRow> rows = rows_with({3.0, 3.0, 3.0, 0.0, 3.0, 3.0, 0.0});
  rows[2].lost = true;
  rows[5].T_map_base_estimate.reset();
  const WrongScans all = since(0.0, rows);
  EXPECT_EQ(all.scans, 7);
  EXPECT_EQ(all.wrong, 3);
  EXPECT_EQ(all.longest_s, 2.0);
  EXPECT_EQ(*all.share(), 3.0 / 7.0);
}

TEST(WrongScans, CountFromATimeOn) {
  const std::vector<MetricRow> rows = rows_with({3.0, 3.0, 3.0, 3.0, 0.0});
  const WrongScans late = since(2.0, rows);
  EXPECT_EQ(late.scans, 3);
  EXPECT_EQ(late.wrong, 2);
  EXPECT_EQ(late.longest_s, 2.0);
}

TEST(WrongScans, LastUntilTheEnd) { EXPECT_EQ(since(0.0, rows_with({0.0, 3.0})).longest_s, 9.0); }

TEST(WrongScans, WithoutTruthAreNotCountedAndEndTheTime) {
  std::vector<MetricRow> rows = rows_with({3.0, 3.0, 3.0, 3.0, 3.0, 0.0});
  rows[1].T_map_base_true.reset();
  rows[2].torn = true;
  const WrongScans some = since(0.0, rows);
  EXPECT_EQ(some.scans, 4);
  EXPECT_EQ(some.wrong, 3);
  EXPECT_EQ(some.longest_s, 2.0);
}

TEST(WrongScans, AddUp) {
  WrongScans sum{10, 2, 0.5};
  sum.add({30, 8, 2.5});
  sum.add({0, 0, 0.0});
  EXPECT_EQ(sum.scans, 40);
  EXPECT_EQ(*sum.share(), 0.25);
  EXPECT_EQ(sum.longest_s, 2.5);
  EXPECT_FALSE(WrongScans{}.share());
}

}  // namespace
}  // namespace castaway::testbed
