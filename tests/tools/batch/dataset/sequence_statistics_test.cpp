#include "tools/batch/dataset/sequence_statistics.hpp"

#include <gtest/gtest.h>

#include "tests/tools/support/table_records.hpp"

namespace castaway::testbed {
namespace {

OdometryFrame odometry_at(double x, double odometry_x) {
  OdometryFrame frame;
  frame.odometry = {localization::from_seconds(x), {odometry_x, 0.0, 0.0}};
  frame.true_pose = SE2{x, 1.0, 0.0};
  return frame;
}

TEST(OdometryDrift, IsTakenOverTwoMetres) {
  OdometryDrift drift;
  for (int i = 0; i <= 40; ++i) drift.add(odometry_at(0.125 * i, 1.1 * 0.125 * i));
  ASSERT_TRUE(drift.per_metre());
  EXPECT_NEAR(*drift.per_metre(), 0.1, 1e-9);
  EXPECT_NEAR(*drift.yaw_per_metre(), 0.0, 1e-9);
  ASSERT_EQ(drift.curve().size(), 5U);
  EXPECT_EQ(drift.curve()[4].first, 5);
  EXPECT_NEAR(drift.curve()[4].second, 0.5, 1e-9);
}

TEST(OdometryDrift, StartsAnewAfterAKidnap) {
  OdometryDrift drift;
  for (int i = 0; i <= 8; ++i) drift.add(odometry_at(0.125 * i, 0.125 * i));
  drift.restart();
  drift.add(odometry_at(100.0, 1.0));
  drift.add(odometry_at(101.0, 2.5));
  EXPECT_FALSE(drift.per_metre());
  ASSERT_EQ(drift.curve().size(), 2U);
  EXPECT_EQ(drift.curve()[1].first, 1);
  EXPECT_NEAR(drift.curve()[1].second, 0.5, 1e-12);
}

TEST(SequenceStatistics, CountWhatGoesBy) {
  SequenceStatistics statistics;
  StatisticsSink sink(statistics, table_context());
  play_two_scans(sink);
  const auto json = statistics.json();
  EXPECT_EQ(json.at("scans"), 2);
  EXPECT_EQ(json.at("beams"), 6);
  EXPECT_EQ(json.at("people"), 1);
  EXPECT_EQ(json.at("duration_s"), 2.1);
  ASSERT_EQ(json.at("kidnaps").size(), 1U);
  EXPECT_EQ(json.at("kidnaps")[0].at("kind"), "teleport");
  EXPECT_EQ(json.at("kidnaps")[0].at("distance_m"), 4.0);
  EXPECT_EQ(json.at("lost").at("mh_amcl"), 0.0);
  EXPECT_EQ(json.at("difficulty").at("ambiguity"), 0.25);
  EXPECT_NEAR(json.at("difficulty").at("occluded_mean").get<double>(), 1.0 / 3.0, 1e-6);
  EXPECT_TRUE(json.at("difficulty").at("odometry_error_per_m").is_null());
  const auto& counted = json.at("statistics");
  EXPECT_EQ(counted.at("ranges")[3], 2);  // 1.5 m
  EXPECT_EQ(counted.at("ranges")[1], 2);  // 0.75 m; misses are in no bin.
  EXPECT_EQ(counted.at("classes").at("person"), 2);
  EXPECT_EQ(counted.at("classes").at("none"), 2);
  EXPECT_EQ(counted.at("occluded")[6], 2);
  EXPECT_EQ(counted.at("coverage").dump(), "[[0,0,2]]");
}

TEST(SequenceStatistics, TheWayOfAKidnapIsNotDriven) {
  SequenceStatistics statistics;
  statistics.add(odometry_at(0.0, 0.0));
  statistics.add(odometry_at(0.5, 0.5));
  statistics.add(kidnap_to(1.0));
  statistics.add(odometry_at(9.0, 0.5));
  statistics.add(odometry_at(9.25, 0.75));
  RunEvent pick_up = kidnap_to(2.0);
  pick_up.what = sim::PickUp{};
  statistics.add(pick_up);
  statistics.add(odometry_at(10.0, 0.75));
  statistics.add(odometry_at(11.0, 0.75));
  EXPECT_EQ(statistics.json().at("distance_m"), 0.75);
  EXPECT_EQ(statistics.json().at("kidnaps").size(), 1U);
}

}  // namespace
}  // namespace castaway::testbed
