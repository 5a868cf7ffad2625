#include "tools/run/metrics/calibration.hpp"

#include <gtest/gtest.h>

#include "tests/tools/support/metric_rows.hpp"

namespace castaway::testbed {
namespace {

TEST(Calibration, SortsByTheStatedProbability) {
  Calibration calibration;
  calibration.add(0.0, false);
  calibration.add(0.1, true);
  calibration.add(0.95, true);
  calibration.add(0.97, false);
  calibration.add(1.0, true);
  EXPECT_EQ(calibration.scans(), 5);
  EXPECT_EQ(calibration.bins[0].scans, 1);
  EXPECT_EQ(calibration.bins[1].right, 1);
  EXPECT_EQ(calibration.bins[9].scans, 3);
  EXPECT_EQ(calibration.bins[9].right, 2);
  EXPECT_NEAR(*calibration.bins[9].stated(), (0.95 + 0.97 + 1.0) / 3.0, 1e-12);
  EXPECT_NEAR(*calibration.bins[9].observed(), 2.0 / 3.0, 1e-12);
  EXPECT_NEAR(calibration.bins[9].interval().low, 0.208, 0.001);  // 2 of 3
  EXPECT_FALSE(calibration.bins[5].stated());
  EXPECT_FALSE(calibration.bins[5].observed());
}

TEST(Calibration, CountsSureOutputsByThemselvesToo) {
  Calibration calibration;
  EXPECT_FALSE(calibration.sure.stated());
  calibration.add(0.9899, false);
  calibration.add(0.99, true);
  calibration.add(0.995, false);
  calibration.add(0.999, true);
  calibration.add(1.0, true);
  EXPECT_EQ(calibration.sure.scans, 4);
  EXPECT_EQ(calibration.sure.right, 3);
  EXPECT_NEAR(*calibration.sure.stated(), (0.99 + 0.995 + 0.999 + 1.0) / 4.0, 1e-12);
  EXPECT_EQ(*calibration.sure.observed(), 0.75);
  EXPECT_EQ(calibration.bins[9].scans, 5);
  EXPECT_EQ(calibration.scans(), 5);
}

TEST(Calibration, HasTheMeanSquareAsItsBrierScore) {
  Calibration calibration;
  EXPECT_FALSE(calibration.brier());
  calibration.add(0.9, true);   // 0.01
  calibration.add(0.8, false);  // 0.64
  calibration.add(0.5, true);   // 0.25
  EXPECT_NEAR(*calibration.brier(), 0.9 / 3.0, 1e-12);
}

TEST(Calibration, CutsWhatIsNoProbability) {
  Calibration calibration;
  calibration.add(1.2, true);
  calibration.add(-0.1, false);
  EXPECT_EQ(calibration.brier(), 0.0);
  EXPECT_EQ(calibration.bins[9].scans, 1);
  EXPECT_EQ(calibration.bins[0].scans, 1);
}

TEST(Calibration, AddsUp) {
  Calibration one;
  one.add(0.9, true);
  Calibration two;
  two.add(0.9, false);
  two.add(0.2, false);
  one.add(two);
  EXPECT_EQ(one.sure.scans, 0);
  EXPECT_EQ(one.scans(), 3);
  EXPECT_EQ(one.bins[9].scans, 2);
  EXPECT_EQ(one.bins[9].right, 1);
  EXPECT_NEAR(*one.brier(), (0.01 + 0.81 + 0.04) / 3.0, 1e-12);
}

TEST(Calibration, AddsUpSureOutputs) {
  Calibration one;
  one.add(1.0, true);
  Calibration two;
  two.add(0.99, false);
  one.add(two);
  EXPECT_EQ(one.sure.scans, 2);
  EXPECT_EQ(one.sure.right, 1);
  EXPECT_EQ(*one.sure.stated(), 0.995);
}

TEST(CalibrationOf, TakesRowsWithTruthAndEstimate) {
  std::vector<MetricRow> rows = rows_with({0.0, 0.0, 3.0, 0.0});
  for (MetricRow& row : rows) row.probability = 0.75;
  rows[0].T_map_base_true.reset();
  rows[1].T_map_base_estimate.reset();
  const Calibration calibration = calibration_of(rows, {});
  EXPECT_EQ(calibration.bins[7].scans, 2);
  EXPECT_EQ(calibration.bins[7].right, 1);
  EXPECT_NEAR(*calibration.brier(), (0.5625 + 0.0625) / 2.0, 1e-12);
}

}  // namespace
}  // namespace castaway::testbed
