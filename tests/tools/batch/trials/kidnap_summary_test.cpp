#include "tools/batch/trials/kidnap_summary.hpp"

#include <gtest/gtest.h>

#include "tests/tools/support/metric_rows.hpp"

namespace castaway::testbed {
namespace {

/// Ten rows with a kidnap at 2.5 s: wrong at 3, 4 and 5 s, right from 6 s on.
std::vector<MetricRow> kidnapped() {
  return rows_with({0.1, 0.1, 0.1, 5.0, 5.0, 5.0, 0.2, 0.2, 0.2, 0.2});
}

KidnapOutcome outcome_of(const std::vector<MetricRow>& rows) {
  return kidnap_outcome(rows, {kidnap_at(2.5)}, from_seconds(10.0));
}

TEST(KidnapOutcome, TimesTheWayBack) {
  auto rows = kidnapped();
  rows[4].lost = rows[5].lost = rows[6].lost = true;
  const KidnapOutcome outcome = outcome_of(rows);
  EXPECT_DOUBLE_EQ(*outcome.alarm_s, 1.5);
  EXPECT_DOUBLE_EQ(*outcome.noticed_s, 1.5);
  EXPECT_DOUBLE_EQ(*outcome.recovered_s, 3.5);
  EXPECT_DOUBLE_EQ(*outcome.confident_s, 4.5);
  EXPECT_EQ(outcome.since_kidnap.scans, 7);
  EXPECT_EQ(outcome.since_kidnap.wrong, 1);  // at 3 s; from then on it raises the alarm
  EXPECT_EQ(outcome.since_kidnap.longest_s, 1.0);
  EXPECT_EQ(outcome.calibration.scans(), 7);
}

TEST(KidnapOutcome, CountsTheTimeUpToTheAnswer) {
  auto rows = kidnapped();
  rows[6].delivered = from_seconds(6.25);
  EXPECT_DOUBLE_EQ(*outcome_of(rows).recovered_s, 3.75);
}

TEST(KidnapOutcome, TracksBeforeTheKidnapAndAfterTheRecovery) {
  const KidnapOutcome outcome = outcome_of(kidnapped());
  ASSERT_EQ(outcome.tracking.size(), 7U);
  EXPECT_NEAR(outcome.tracking[2].position_m, 0.1, 1e-12);
  EXPECT_NEAR(outcome.tracking[3].position_m, 0.2, 1e-12);
}

TEST(KidnapOutcome, LeavesATornScanOutOfTheTracking) {
  auto rows = kidnapped();
  rows[2].T_map_base_estimate->x += 5.0;  // The answer is already that after the kidnap.
  rows[2].delivered = from_seconds(2.6);
  const KidnapOutcome outcome = outcome_of(rows);
  ASSERT_EQ(outcome.tracking.size(), 6U);
  for (const PoseError& error : outcome.tracking) EXPECT_LT(error.position_m, 0.3);
}

TEST(KidnapOutcome, SaysWhatNeverHappened) {
  auto rows = rows_with({0.0, 0.0, 0.0, 5.0, 5.0});
  const KidnapOutcome outcome = outcome_of(rows);
  EXPECT_FALSE(outcome.recovered_s || outcome.confident_s || outcome.alarm_s || outcome.noticed_s);
  EXPECT_EQ(outcome.since_kidnap.wrong, 2);
  EXPECT_EQ(outcome.since_kidnap.longest_s, 7.0);  // to the end, at 10 s
}

TEST(KidnapOutcome, IsNotRecoveredWhereItGoesWrongAgain) {
  auto rows = kidnapped();
  rows[9] = row_at(9.0, 4.0);
  const KidnapOutcome outcome = outcome_of(rows);
  EXPECT_FALSE(outcome.recovered_s);
  EXPECT_DOUBLE_EQ(*outcome.confident_s, 3.5);
}

TEST(KidnapOutcome, CountsTheScansSinceThePlacesAreDistinguishable) {
  const KidnapOutcome outcome =
      kidnap_outcome(kidnapped(), {kidnap_at(2.5)}, from_seconds(10.0), from_seconds(4.0));
  EXPECT_EQ(outcome.since_kidnap.wrong, 3);
  EXPECT_EQ(outcome.since_distinguishable.scans, 6);
  EXPECT_EQ(outcome.since_distinguishable.wrong, 2);
  EXPECT_EQ(outcome.since_distinguishable.longest_s, 2.0);
  EXPECT_EQ(outcome_of(kidnapped()).since_distinguishable.scans, 0);
}

TEST(Summarise, LeavesOutTrialsThatAreVoid) {
  const KidnapReport counts{0, 6, {}, {}, {0, 0.3}, {outcome_of(kidnapped())}};
  KidnapReport stuck = counts;
  stuck.void_run = VoidRun{sim::VoidReason::kStuck, 1.0};
  const KidnapBatch batch = summarise({stuck, counts}, {"amcl"}, 10.0);
  EXPECT_EQ(batch.voids, 1);
  EXPECT_EQ(batch.kidnaps, 1);
  EXPECT_EQ(batch.rows[0].recovered, 1);
  const KidnapBatch none = summarise({stuck}, {"amcl"}, 10.0);
  EXPECT_EQ(none.voids, 1);
  EXPECT_EQ(none.kidnaps, 0);
  EXPECT_EQ(none.obstacles, 6);
  EXPECT_EQ(none.blocked_share, 0.0);
}

TEST(Summarise, PutsTrialsTogether) {
  KidnapReport early{0, 6, {}, {}, {0, 0.3}, {outcome_of(kidnapped())}};
  KidnapReport late{1, 6, {}, {}, {5, 0.6}, {outcome_of(kidnapped())}};
  late.outcomes[0].recovered_s = 12.0;
  late.outcomes[0].tracking = {{0.4, 0.2}};
  KidnapReport never{2, 6, {}, {}, {4, 0.0}, {outcome_of(rows_with({0.0, 0.0, 0.0, 5.0}))}};
  const KidnapBatch batch = summarise({early, late, never}, {"amcl"}, 10.0);
  EXPECT_EQ(batch.obstacles, 6);
  EXPECT_EQ(batch.kidnaps, 3);
  EXPECT_EQ(batch.top1, 1);
  EXPECT_EQ(batch.top5, 2);
  EXPECT_NEAR(batch.blocked_share, 0.3, 1e-12);
  const KidnapRow& row = batch.rows.at(0);
  EXPECT_EQ(row.localizer, "amcl");
  EXPECT_EQ(row.recovered, 1);
  EXPECT_EQ(row.recovered_s, (std::vector<double>{3.5, 12.0}));
  // 3 * 0.1 + 4 * 0.2 + 0.4 + 3 * 0 metres on 7 + 1 + 3 scans
  EXPECT_NEAR(row.tracking->position_m, 1.5 / 11.0, 1e-12);
  EXPECT_NEAR(row.tracking->yaw_rad, 0.2 / 11.0, 1e-12);
  EXPECT_NEAR(*row.since_kidnap.share(), (3.0 + 3.0 + 1.0) / (7.0 + 7.0 + 1.0), 1e-12);
}

TEST(Summarise, CountsTheTrialsWithDistinguishablePlaces) {
  const KidnapReport never{0, 6, {}, {}, {0, 0.3}, {outcome_of(kidnapped())}};
  KidnapReport distinct = never;
  distinct.distinguishable = from_seconds(4.0);
  distinct.outcomes[0].since_distinguishable = {6, 2, 1.5};
  const KidnapBatch batch = summarise({never, distinct, distinct}, {"amcl"}, 10.0);
  EXPECT_EQ(batch.distinguishable, 2);
  EXPECT_EQ(batch.rows[0].since_distinguishable.scans, 12);
  EXPECT_NEAR(*batch.rows[0].since_distinguishable.share(), 4.0 / 12.0, 1e-12);
  EXPECT_EQ(batch.rows[0].since_distinguishable.longest_s, 1.5);
}

TEST(Summarise, HasNothingToSayOfNoTrials) {
  const KidnapBatch batch = summarise({}, {"amcl"}, 10.0);
  EXPECT_EQ(batch.kidnaps, 0);
  EXPECT_FALSE(batch.rows.at(0).tracking);
}

}  // namespace
}  // namespace castaway::testbed
