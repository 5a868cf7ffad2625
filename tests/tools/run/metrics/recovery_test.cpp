#include "tools/run/metrics/recovery.hpp"

#include <gtest/gtest.h>

#include "tests/tools/support/metric_rows.hpp"

namespace castaway::testbed {
namespace {

constexpr double kWrong = 2.0;  // [m]

/// Rows at 0 to 19 s that are wrong at the indices `wrong`.
std::vector<MetricRow> twenty_rows(const std::vector<std::size_t>& wrong) {
  std::vector<MetricRow> rows = right_rows(20);
  for (const std::size_t i : wrong) rows[i] = row_at(static_cast<double>(i), kWrong);
  return rows;
}

/// The windows of a run of 20 s with a known start.
std::vector<RecoveryWindow> windows_of(const std::vector<MetricRow>& rows,
                                       const std::vector<RunEvent>& kidnaps) {
  return recovery_windows(rows, kidnaps, true, from_seconds(20.0), {});
}

TEST(IsRight, EndsAtTheLimits) {
  EXPECT_TRUE(is_right(row_at(0.0, 0.499, 0.349), {}));
  EXPECT_TRUE(is_right(row_at(0.0, -0.499, -0.349), {}));
  EXPECT_FALSE(is_right(row_at(0.0, 0.5, 0.0), {}));
  EXPECT_FALSE(is_right(row_at(0.0, 0.0, -0.35), {}));
  MetricRow silent = row_at(0.0);
  silent.T_map_base_estimate.reset();
  EXPECT_FALSE(is_right(silent, {}));
}

RunEvent order_at(double at_s) {
  RunEvent order;
  order.stamp = from_seconds(at_s);
  order.what = OperatorEvent{LocalizerOrder::What::kRelocalize};
  return order;
}

TEST(Recovery, WithAnOperatorsHelpIsNone) {
  const auto windows =
      windows_of(twenty_rows({4, 5, 6, 7, 8, 9, 10}), {kidnap_at(4.0), order_at(10.5)});
  ASSERT_EQ(windows.size(), 2U);
  EXPECT_EQ(windows[0].end, from_seconds(10.5));
  EXPECT_TRUE(windows[0].scored);
  EXPECT_FALSE(windows[0].recovered);
  EXPECT_EQ(windows[1].cause, LossCause(OrderedStart{}));
  EXPECT_FALSE(windows[1].scored);
  EXPECT_FALSE(windows[1].recovered);
}

TEST(Recovery, BeforeAnOperatorsHelpCounts) {
  const auto windows = windows_of(twenty_rows({4, 12, 13, 14}), {kidnap_at(4.0), order_at(12.0)});
  EXPECT_EQ(windows[0].recovered, from_seconds(5.0));
  EXPECT_FALSE(windows_of(twenty_rows({4, 5}), {kidnap_at(4.0), order_at(6.0)})[0].scored);
}

TEST(Recovery, IsTheFirstRowFromWhichAllAreRight) {
  const auto windows = windows_of(twenty_rows({4, 5, 6, 9}), {kidnap_at(4.0)});
  ASSERT_EQ(windows.size(), 1U);
  EXPECT_EQ(windows[0].begin, from_seconds(4.0));
  EXPECT_EQ(windows[0].end, from_seconds(20.0));
  EXPECT_TRUE(windows[0].scored);
  EXPECT_EQ(windows[0].recovered, from_seconds(10.0));
  EXPECT_NEAR(windows[0].distance_m, 0.6, 1e-12);  // 0.1 m per second
}

TEST(Recovery, OfACarriedRobotIsTimedFromWhereItWasPutDown) {
  RunEvent carry = kidnap_at(8.0);
  carry.since = from_seconds(4.0);
  carry.what = KidnapEvent{sim::KidnapKind::kCarry};
  auto rows = twenty_rows({4, 5, 6, 7, 8, 9});
  rows[6].lost = true;
  const RecoveryWindow window = windows_of(rows, {kidnap_at(1.0), carry})[1];
  EXPECT_EQ(window.cause, LossCause(KidnapEvent::How(sim::KidnapKind::kCarry)));
  EXPECT_EQ(window.taken, from_seconds(4.0));
  EXPECT_EQ(window.begin, from_seconds(8.0));
  EXPECT_EQ(window.recovered, from_seconds(10.0));
  EXPECT_EQ(window.noticed, from_seconds(6.0));
  EXPECT_EQ(window.detection_delay_s(), 2.0);
  EXPECT_TRUE(window.is_lost_at(from_seconds(4.0)));
  EXPECT_FALSE(window.is_lost_at(from_seconds(10.0)));
  EXPECT_EQ(windows_of(rows, {kidnap_at(1.0), carry})[0].end, from_seconds(4.0));
}

TEST(Recovery, IsNotUndoneByAScanThatTheNextKidnapTore) {
  auto rows = twenty_rows({3, 9});
  const std::vector<RunEvent> kidnaps{kidnap_at(3.0), kidnap_at(9.5)};
  EXPECT_FALSE(windows_of(rows, kidnaps)[0].recovered.has_value());
  rows[9].torn = true;
  const auto windows = windows_of(rows, kidnaps);
  EXPECT_TRUE(windows[0].recovered.has_value());
}

TEST(Recovery, CountsTheTimeThatIsWrongWithoutAlarm) {
  auto rows = twenty_rows({2, 4, 5, 6, 9});
  rows[5].lost = true;
  const auto windows = windows_of(rows, {kidnap_at(4.5), kidnap_at(9.5)});
  EXPECT_EQ(windows[0].wrong_lock_s, 0.5 + 1.0 + 0.5);  // rows 4 and 6, and 9 until the next kidnap
  EXPECT_EQ(windows[1].wrong_lock_s, 0.5);
}

TEST(Recovery, NeedsEveryRowToTheEndToBeRight) {
  EXPECT_FALSE(windows_of(twenty_rows({4, 19}), {kidnap_at(4.0)})[0].recovered);
}

TEST(Recovery, CountsARowWithoutEstimateAsWrong) {
  auto rows = twenty_rows({4});
  rows[8].T_map_base_estimate.reset();
  EXPECT_EQ(windows_of(rows, {kidnap_at(4.0)})[0].recovered, from_seconds(9.0));
}

TEST(Recovery, ReadsNothingFromARowWithoutTruth) {
  auto rows = twenty_rows({4, 8});
  rows[8].T_map_base_true.reset();
  EXPECT_EQ(windows_of(rows, {kidnap_at(4.0)})[0].recovered, from_seconds(5.0));
}

TEST(Recovery, LeavesFiveSecondsOfItsWindow) {
  auto rows = twenty_rows({4, 14});
  EXPECT_EQ(windows_of(rows, {kidnap_at(4.0)})[0].recovered, from_seconds(15.0));
  rows[15] = row_at(15.0, kWrong);
  EXPECT_FALSE(windows_of(rows, {kidnap_at(4.0)})[0].recovered);
}

TEST(Recovery, IsTimedByTheDeliveryOfTheAnswer) {
  auto rows = twenty_rows({4, 5});
  for (MetricRow& row : rows) row.delivered = row.stamp + from_seconds(0.2);
  EXPECT_EQ(windows_of(rows, {kidnap_at(4.0)})[0].recovered, from_seconds(6.2));
}

TEST(Recovery, LeavesFiveSecondsAfterItsDelivery) {
  auto rows = twenty_rows({4, 14});
  rows[15].delivered = from_seconds(15.2);
  EXPECT_FALSE(windows_of(rows, {kidnap_at(4.0)})[0].recovered);
}

TEST(Recovery, IsJudgedUpToTheNextKidnap) {
  const auto windows = windows_of(twenty_rows({2, 10, 11}), {kidnap_at(2.0), kidnap_at(10.0)});
  ASSERT_EQ(windows.size(), 2U);
  EXPECT_EQ(windows[0].end, from_seconds(10.0));
  EXPECT_EQ(windows[0].recovered, from_seconds(3.0));
  EXPECT_EQ(windows[1].recovered, from_seconds(12.0));
}

TEST(Recovery, IsNotScoredInAWindowOfLessThanFiveSeconds) {
  const auto windows = windows_of(twenty_rows({}), {kidnap_at(10.0), kidnap_at(14.9)});
  EXPECT_FALSE(windows[0].scored);
  EXPECT_FALSE(windows[0].recovered);
  EXPECT_TRUE(windows[1].scored);
}

TEST(Recovery, OfAnUnknownStartBeginsAtTheFirstRow) {
  auto rows = twenty_rows({0, 1, 2});
  rows.erase(rows.begin());
  const auto windows = recovery_windows(rows, {kidnap_at(12.0)}, false, from_seconds(20.0), {});
  ASSERT_EQ(windows.size(), 2U);
  EXPECT_TRUE(windows[0].unknown_start);
  EXPECT_FALSE(windows[1].unknown_start);
  EXPECT_EQ(windows[0].begin, from_seconds(1.0));
  EXPECT_EQ(windows[0].recovered, from_seconds(3.0));
}

TEST(Recovery, OfNoRowsIsNothing) { EXPECT_TRUE(windows_of({}, {kidnap_at(1.0)}).empty()); }

TEST(RecoveryWindow, IsLostUpToTheRecoveryOrItsEnd) {
  RecoveryWindow window{
      .taken = from_seconds(4.0), .begin = from_seconds(4.0), .end = from_seconds(20.0)};
  EXPECT_FALSE(window.is_lost_at(from_seconds(3.9)));
  EXPECT_TRUE(window.is_lost_at(from_seconds(19.9)));
  EXPECT_FALSE(window.is_lost_at(from_seconds(20.0)));
  window.recovered = from_seconds(6.0);
  EXPECT_TRUE(window.is_lost_at(from_seconds(4.0)));
  EXPECT_FALSE(window.is_lost_at(from_seconds(6.0)));
}

TEST(Notice, IsTheFirstAlarmOrRightAnswer) {
  auto rows = twenty_rows({4, 5, 6, 7});
  EXPECT_EQ(windows_of(rows, {kidnap_at(4.0)})[0].noticed, from_seconds(8.0));
  rows[6].lost = true;
  rows[6].delivered = from_seconds(6.2);
  EXPECT_EQ(windows_of(rows, {kidnap_at(4.0)})[0].noticed, from_seconds(6.2));
}

TEST(Notice, MayComeFromAScanThatBeganBeforeTheKidnap) {
  auto rows = twenty_rows({5, 6, 7});
  rows[4].delivered = from_seconds(4.9);
  const auto kidnap = kidnap_at(4.5);
  EXPECT_EQ(windows_of(rows, {kidnap})[0].noticed,
            from_seconds(8.0));  // row 4 is right, but of before the kidnap
  rows[4].lost = true;
  EXPECT_EQ(windows_of(rows, {kidnap})[0].noticed, from_seconds(4.9));
  rows[4].delivered = from_seconds(4.4);
  EXPECT_EQ(windows_of(rows, {kidnap})[0].noticed, from_seconds(8.0));
}

TEST(Notice, IsNotMadeByTheFirstRowOfTheNextWindow) {
  auto rows = twenty_rows({2, 3, 4, 5, 6, 7, 8});
  const auto windows = windows_of(rows, {kidnap_at(2.0), kidnap_at(9.0)});
  EXPECT_FALSE(windows[0].noticed);
  EXPECT_EQ(windows[1].noticed, from_seconds(9.0));
}

TEST(Notice, MayBeTheLastAnswerOfTheRun) {
  auto rows = twenty_rows({4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19});
  rows[19].lost = true;
  rows[19].delivered = from_seconds(20.0);
  EXPECT_EQ(windows_of(rows, {kidnap_at(4.0)})[0].noticed, from_seconds(20.0));
}

TEST(Notice, ThatComesAfterTheNextKidnapIsOfThatOne) {
  auto rows = twenty_rows({2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19});
  rows[9].lost = true;
  rows[9].delivered = from_seconds(9.9);
  const auto windows = windows_of(rows, {kidnap_at(2.0), kidnap_at(9.5)});
  EXPECT_FALSE(windows[0].noticed);
  EXPECT_EQ(windows[1].noticed, from_seconds(9.9));
}

}  // namespace
}  // namespace castaway::testbed
