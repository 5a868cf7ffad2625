#include "tools/batch/trials/kidnap_text.hpp"

#include <cmath>
#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>

namespace castaway::testbed {
namespace {

KidnapOutcome found_outcome() {
  KidnapOutcome outcome;
  outcome.recovered_s = 1.0 / 3.0;
  outcome.noticed_s = 0.1;
  outcome.tracking = {{0.1, 0.2}, {1.0 / 7.0, 3.0}};
  outcome.since_kidnap = {150, 12, 0.7};
  outcome.since_distinguishable = {140, 2, 0.2};
  outcome.calibration.add(0.995, true);
  outcome.calibration.add(0.3, false);
  return outcome;
}

KidnapReport full_report() {
  KidnapReport report;
  report.index = 7;
  report.obstacles = 3;
  report.T_map_from = {1.0 / 3.0, -2.0, 3.0};
  report.T_map_to = {0.0, 1e-9, -1.0};
  report.search = {4, 0.25, -3.5, -7.0};
  report.outcomes = {found_outcome(), {}};
  report.void_run = VoidRun{sim::VoidReason::kStuck, 2.5};
  report.distinguishable = Stamp(123456789012345);
  return report;
}

TEST(KidnapText, HoldsEveryValueExactly) {
  const KidnapReport report = full_report();
  const KidnapReport read = unpack_report(pack_report(report));
  EXPECT_EQ(read.index, 7);
  EXPECT_EQ(read.obstacles, 3);
  EXPECT_EQ(read.T_map_from, report.T_map_from);
  EXPECT_EQ(read.T_map_to, report.T_map_to);
  EXPECT_EQ(read.search.rank, 4U);
  EXPECT_EQ(read.search.blocked_share, 0.25);
  EXPECT_EQ(read.search.right, -3.5);
  EXPECT_EQ(read.search.fifth, -7.0);
  EXPECT_EQ(read.void_run->reason, VoidEvent::Reason(sim::VoidReason::kStuck));
  EXPECT_EQ(read.void_run->at_s, 2.5);
  EXPECT_EQ(read.distinguishable, report.distinguishable);
  ASSERT_EQ(read.outcomes.size(), 2U);
  EXPECT_EQ(pack_report(read), pack_report(report));
}

TEST(KidnapText, HoldsTheOutcomesExactly) {
  const KidnapOutcome outcome = found_outcome();
  const KidnapOutcome read = unpack_report(pack_report(full_report())).outcomes[0];
  EXPECT_EQ(read.recovered_s, outcome.recovered_s);
  EXPECT_EQ(read.confident_s, std::nullopt);
  EXPECT_EQ(read.alarm_s, std::nullopt);
  EXPECT_EQ(read.noticed_s, outcome.noticed_s);
  ASSERT_EQ(read.tracking.size(), 2U);
  EXPECT_EQ(read.tracking[1].position_m, 1.0 / 7.0);
  EXPECT_EQ(read.tracking[1].yaw_rad, 3.0);
  EXPECT_EQ(read.since_kidnap.wrong, 12);
  EXPECT_EQ(read.since_distinguishable.longest_s, 0.2);
  EXPECT_EQ(read.calibration.brier(), outcome.calibration.brier());
  EXPECT_EQ(read.calibration.sure.scans, 1);
}

/// Localizers of users need not state a probability.
TEST(KidnapText, HoldsWhatIsNoNumber) {
  KidnapReport report = full_report();
  report.outcomes[0].calibration.squares = std::numeric_limits<double>::quiet_NaN();
  report.search.right = -std::numeric_limits<double>::infinity();
  report.search.fifth = std::numeric_limits<double>::infinity();
  const KidnapReport read = unpack_report(pack_report(report));
  EXPECT_TRUE(std::isnan(read.outcomes[0].calibration.squares));
  EXPECT_EQ(read.search.right, report.search.right);
  EXPECT_EQ(read.search.fifth, report.search.fifth);
}

TEST(KidnapText, OmitsWhatATrialDoesNotHave) {
  const KidnapReport read = unpack_report(pack_report({}));
  EXPECT_FALSE(read.search.rank);
  EXPECT_FALSE(read.void_run);
  EXPECT_FALSE(read.distinguishable);
  EXPECT_TRUE(read.outcomes.empty());
}

TEST(KidnapText, OfSomethingElseIsRefused) {
  const std::string text = pack_report(full_report());
  for (const std::string& other : {std::string(), std::string("{}"), text.substr(0, 40)}) {
    EXPECT_THROW(unpack_report(other), std::runtime_error) << other;
  }
}

}  // namespace
}  // namespace castaway::testbed
