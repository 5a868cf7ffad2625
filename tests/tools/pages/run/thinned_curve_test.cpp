#include "tools/pages/run/run_folder.hpp"

#include <gtest/gtest.h>

namespace castaway::testbed {
namespace {

ReportRow row(double stamp_s, std::optional<double> error) {
  ReportRow made;
  made.stamp_s = stamp_s;
  made.position_error_m = error;
  return made;
}

TEST(ThinnedCurve, KeepsAllRowsUpToItsLimit) {
  ThinnedCurve curve(10);
  for (int i = 0; i < 10; ++i) curve.add(row(i, 0.1));
  const auto rows = curve.take();
  ASSERT_EQ(rows.size(), 10U);
  EXPECT_EQ(rows[9].stamp_s, 9.0);
}

TEST(ThinnedCurve, StaysBelowItsLimitHoweverManyThereAre) {
  ThinnedCurve curve(10);
  for (int i = 0; i < 1000; ++i) curve.add(row(i, 0.1));
  const auto rows = curve.take();
  EXPECT_LE(rows.size(), 10U);
  EXPECT_GE(rows.size(), 5U);
  for (std::size_t i = 1; i < rows.size(); ++i) EXPECT_LT(rows[i - 1].stamp_s, rows[i].stamp_s);
}

TEST(ThinnedCurve, KeepsPeaksAndGaps) {
  ThinnedCurve peak(10);
  ThinnedCurve gap(10);
  for (int i = 0; i < 1000; ++i) {
    peak.add(row(i, i == 437 ? 5.0 : 0.1));
    gap.add(row(i, i == 437 ? std::nullopt : std::optional(0.1)));
  }
  int peaks = 0;
  int gaps = 0;
  for (const ReportRow& kept : peak.take()) peaks += kept.position_error_m == 5.0 ? 1 : 0;
  for (const ReportRow& kept : gap.take()) gaps += kept.position_error_m ? 0 : 1;
  EXPECT_EQ(peaks, 1);
  EXPECT_EQ(gaps, 1);
}

}  // namespace
}  // namespace castaway::testbed
