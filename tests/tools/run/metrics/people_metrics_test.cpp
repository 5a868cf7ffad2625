#include "tools/run/metrics/people_metrics.hpp"

#include <gtest/gtest.h>

namespace castaway::testbed {
namespace {

PeopleTruth at(const std::vector<double>& gaps, double beams = 0.0) {
  PeopleTruth truth;
  for (const double gap : gaps) {
    truth.people.push_back({static_cast<int>(truth.people.size()), {}, {0.0, 0.0}, gap});
  }
  truth.beams_on_people = beams;
  return truth;
}

TEST(PeopleMeter, OfNobodyIsNothing) {
  PeopleMeter meter;
  meter.add(PeopleTruth{});
  EXPECT_FALSE(meter.metrics());
}

TEST(PeopleMeter, FindsTheClosest) {
  PeopleMeter meter;
  meter.add(at({2.0, 3.0}));
  meter.add(at({1.5, 0.3}));
  meter.add(at({2.5, 0.9}));
  EXPECT_EQ(meter.metrics()->people, 2);
  EXPECT_EQ(meter.metrics()->closest_m, 0.3);
  EXPECT_EQ(meter.metrics()->closest_person, 1);
}

TEST(PeopleMeter, CountsEntriesIntoZonesWithSomeSlack) {
  PeopleMeter meter;
  for (const double gap : {2.0, 1.1, 1.25, 1.1, 1.4, 1.1, 0.4, 4.0}) meter.add(at({gap}));
  const PeopleMetrics metrics = *meter.metrics();
  EXPECT_EQ(metrics.entries[0], 1);  // 0.4
  EXPECT_EQ(metrics.entries[1], 2);  // 1.25 is still inside, 1.4 is not.
  EXPECT_EQ(metrics.entries[2], 1);
  EXPECT_DOUBLE_EQ(metrics.share[0], 1.0 / 8.0);
  EXPECT_DOUBLE_EQ(metrics.share[1], 5.0 / 8.0);
  EXPECT_DOUBLE_EQ(metrics.share[2], 7.0 / 8.0);
}

TEST(PeopleMeter, AveragesTheBeams) {
  PeopleMeter meter;
  meter.add(at({1.0}, 0.1));
  meter.add(at({1.0}, 0.4));
  EXPECT_DOUBLE_EQ(meter.metrics()->beams_mean, 0.25);
  EXPECT_DOUBLE_EQ(meter.metrics()->beams_max, 0.4);
}

}  // namespace
}  // namespace castaway::testbed
