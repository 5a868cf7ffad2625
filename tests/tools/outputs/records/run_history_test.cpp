#include "tools/outputs/records/run_history.hpp"

#include <gtest/gtest.h>

#include "tests/tools/support/records.hpp"

namespace castaway::testbed {
namespace {

TEST(RunHistory, KeepsRowsByStampHoweverScansAreDelivered) {
  RunHistory history(run_of({"a"}));
  for (const double t : {0.0, 0.2, 0.1, 0.3}) history.add(record_at(t, {"a"}));
  ASSERT_EQ(history.rows[0].size(), 4U);
  for (std::size_t i = 1; i < 4; ++i) {
    EXPECT_LT(history.rows[0][i - 1].stamp, history.rows[0][i].stamp);
  }
}

TEST(RunHistory, LeavesOutEverySecondRowWhereThereAreTooMany) {
  RunHistory history(run_of({"a"}));
  for (int i = 0; i < 9; ++i) history.add(record_at(0.1 * i, {"a"}));
  history.thin(9);
  EXPECT_EQ(history.rows[0].size(), 9U);
  history.thin(8);
  ASSERT_EQ(history.rows[0].size(), 5U);
  EXPECT_EQ(history.rows[0][1].stamp, record_at(0.2, {"a"}).stamp);
  history.add(record_at(0.9, {"a"}));  // This one is dropped, too.
  history.add(record_at(1.0, {"a"}));
  ASSERT_EQ(history.rows[0].size(), 6U);
  EXPECT_EQ(history.rows[0][5].stamp, record_at(1.0, {"a"}).stamp);
}

TEST(RunHistory, RowsHoldWhatTheEstimateSaysOfItself) {
  RunHistory history(run_of({"a", "silent"}));
  ScanRecord record = record_at(0.0, {"a", "silent"});
  record.localizers[0].estimate->covariance.diagonal() << 0.02, 0.06, 0.1;
  record.localizers[1].estimate.reset();
  history.add(record);
  const MetricRow& row = history.rows[0][0];
  EXPECT_EQ(row.quality, 0.75);
  EXPECT_EQ(row.probability, 0.5);
  EXPECT_DOUBLE_EQ(row.sigma_m, 0.2);  // sqrt((0.02 + 0.06) / 2)
  EXPECT_EQ(row.answered(), record.delivered);
  EXPECT_FALSE(history.rows[1][0].T_map_base_estimate);
}

}  // namespace
}  // namespace castaway::testbed
