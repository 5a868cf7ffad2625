#include "localization/mh_amcl/mh_amcl.hpp"

#include <limits>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/grid_drive.hpp"

namespace castaway::localization {
namespace {

using test::kForward;
using test::known_start;
using test::kStart;

bool is_right(const Localizer& localizer, const SE2& truth) {
  const auto estimate = localizer.estimate();
  return estimate && distance(estimate->T_map_base, truth) < 0.15 &&
         yaw_distance(estimate->T_map_base, truth) < 0.1;
}

TEST(MhAmcl, TracksFromAKnownStart) {
  MhAmcl localizer({}, test::office(), 1);
  localizer.initialize(known_start(kStart));
  test::GridDrive drive(test::office(), kStart);
  double worst = 0.0;
  for (int i = 0; i < 60; ++i) {
    drive.step(localizer, kForward);
    ASSERT_TRUE(localizer.estimate());
    worst = std::max(worst, distance(localizer.estimate()->T_map_base, drive.truth()));
  }
  EXPECT_LT(worst, 0.06);
  EXPECT_FALSE(localizer.estimate()->lost);
  EXPECT_GT(localizer.estimate()->quality, 0.7);
  EXPECT_EQ(localizer.estimate()->stamp, drive.now());
}

TEST(MhAmcl, FindsItselfFromAnUnknownStart) {
  MhAmcl localizer({}, test::office(), 1);
  test::GridDrive drive(test::office(), kStart);
  for (int i = 0; i < 40; ++i) drive.step(localizer, kForward);
  EXPECT_TRUE(is_right(localizer, drive.truth()));
  EXPECT_FALSE(localizer.estimate()->lost);
}

/// Rooms side by side that look alike.
OccupancyGrid like_rooms(int count) {
  OccupancyGrid grid;
  grid.frame = {80 * count, 80, 0.05, {}};
  grid.cells.assign(grid.frame.size(), CellState::kOccupied);
  for (int i = 0; i < count; ++i) {
    const double x = 4.0 * i;
    test::fill(grid, x + 0.2, 0.2, x + 3.8, 3.8, CellState::kFree);
    test::fill(grid, x + 0.8, 2.0, x + 1.4, 2.4, CellState::kOccupied);
  }
  return grid;
}

TEST(MhAmcl, IsNotSureWhereItsListIsTooShortForAllLookAlikes) {
  MhAmclConfig config;
  config.create.quick_candidates = 1;
  config.watch.candidates = 1;
  MhAmcl localizer(config, like_rooms(3), 1);
  test::GridDrive drive(like_rooms(3), {6.5, 1.2, 0.4});
  for (int i = 0; i < 20; ++i) {  // As long as the history remembers the start.
    drive.step(localizer, {0.01, 0.0, 0.03});
    ASSERT_TRUE(localizer.estimate());
    EXPECT_LT(localizer.estimate()->probability, 0.7) << i;
    EXPECT_TRUE(localizer.estimate()->lost);
  }
}

TEST(MhAmcl, FindsItselfOnTheMoveThoughTheSearchTakesManyScans) {
  MhAmclConfig config;
  config.match.slice = 200;
  MhAmcl localizer(config, test::office(), 1);
  test::GridDrive drive(test::office(), kStart);
  for (int i = 0; i < 5; ++i) drive.step(localizer, kForward);
  EXPECT_FALSE(localizer.estimate());  // It keeps searching.
  for (int i = 0; i < 75; ++i) drive.step(localizer, kForward);
  EXPECT_TRUE(is_right(localizer, drive.truth()));
  EXPECT_FALSE(localizer.estimate()->lost);
}

TEST(MhAmcl, BecomesConfidentStandingStill) {
  MhAmcl localizer({}, test::office(), 1);
  test::GridDrive drive(test::office(), kStart);
  for (int i = 0; i < 60; ++i) drive.step(localizer, {});
  EXPECT_TRUE(is_right(localizer, drive.truth()));
  EXPECT_FALSE(localizer.estimate()->lost);
}

/// Drives for a while; returns the stated probability at the first scan without the alarm.
std::optional<double> found_at(const MhAmclConfig& config, bool knows) {
  MhAmcl localizer(config, test::office(), 1);
  if (knows) localizer.initialize(known_start(kStart));
  test::GridDrive drive(test::office(), kStart);
  for (int i = 0; i < 40; ++i) {
    drive.step(localizer, kForward);
    const auto estimate = localizer.estimate();
    if (estimate && !estimate->lost) return estimate->probability;
  }
  return std::nullopt;
}

TEST(MhAmcl, TakesMoreToBeFoundThanToStaySo) {
  EXPECT_GE(found_at({}, false).value(), 0.998);
  MhAmclConfig strict;
  strict.lost_and_found.found = 0.9999;
  EXPECT_GE(found_at(strict, false).value(), 0.9999);
  EXPECT_LT(found_at({}, false).value(), 0.9999);
  MhAmclConfig never;
  never.lost_and_found.found = 1.0;
  EXPECT_FALSE(found_at(never, false));
  EXPECT_TRUE(found_at(never, true));  // The user's start pose is trusted.
}

TEST(MhAmcl, RaisesTheAlarmAtOnceAndRecoversFromAKidnap) {
  MhAmcl localizer({}, test::office(), 1);
  localizer.initialize(known_start(kStart));
  test::GridDrive drive(test::office(), kStart);
  for (int i = 0; i < 20; ++i) drive.step(localizer, kForward);
  ASSERT_FALSE(localizer.estimate()->lost);
  drive.kidnap({7.5, 6.5, 2.0});
  drive.step(localizer, kForward);
  EXPECT_TRUE(localizer.estimate()->lost || is_right(localizer, drive.truth()));
  for (int i = 0; i < 30; ++i) drive.step(localizer, {0.02, 0.0, 0.03});
  EXPECT_TRUE(is_right(localizer, drive.truth()));
  EXPECT_FALSE(localizer.estimate()->lost);
}

TEST(MhAmcl, BelievesAJumpThatNoKidnapExplainsOnlyAfterAWay) {
  MhAmclConfig config;
  config.lost_and_found.unexplained_cue = 1000.0;
  config.lost_and_found.proving_m = 0.6;
  MhAmcl localizer(config, test::office(), 1);
  localizer.initialize(known_start(kStart));
  test::GridDrive drive(test::office(), kStart);
  for (int i = 0; i < 20; ++i) drive.step(localizer, kForward);
  drive.kidnap({7.5, 6.5, 2.0});
  for (int i = 0; i < 12; ++i) drive.step(localizer, kForward);
  ASSERT_TRUE(is_right(localizer, drive.truth()));
  EXPECT_GT(localizer.estimate()->probability, 0.9);
  EXPECT_TRUE(localizer.estimate()->lost);
  for (int i = 0; i < 12; ++i) drive.step(localizer, kForward);
  EXPECT_TRUE(is_right(localizer, drive.truth()));
  EXPECT_FALSE(localizer.estimate()->lost);
}

TEST(MhAmcl, SearchesOnWhereNothingFitsThoughItStands) {
  MhAmcl localizer({}, test::office(), 1);
  localizer.initialize(known_start(kStart));
  test::GridDrive drive(test::office(), kStart);
  for (int i = 0; i < 300; ++i) drive.step_blind(localizer, {}, 11.0F);  // ends beyond all walls
  drive.kidnap({7.5, 6.5, 2.0});
  int scans = 0;
  while (scans < 100 && !is_right(localizer, drive.truth())) {
    drive.step(localizer, {});
    ++scans;
  }
  EXPECT_LT(scans, 20);
}

TEST(MhAmcl, RecoversFromASlipThatOdometryDidNotSee) {
  MhAmcl localizer({}, test::office(), 1);
  localizer.initialize(known_start(kStart));
  test::GridDrive drive(test::office(), kStart);
  for (int i = 0; i < 20; ++i) drive.step(localizer, kForward);
  drive.kidnap(drive.truth() * SE2{0.6, 0.3, 0.4});
  for (int i = 0; i < 10; ++i) drive.step(localizer, kForward);
  EXPECT_TRUE(is_right(localizer, drive.truth()));
}

TEST(MhAmcl, NamesTheTwinOfAnAmbiguousPlace) {
  // A room without furniture looks the same after half a turn.
  OccupancyGrid room = test::office();
  test::fill(room, 0.2, 0.2, 9.8, 7.8, CellState::kFree);
  MhAmcl localizer({}, room, 1);
  const SE2 truth{3.0, 3.0, 0.3};
  test::GridDrive drive(room, truth);
  for (int i = 0; i < 30; ++i) drive.step(localizer, {});
  const Estimate estimate = *localizer.estimate();
  EXPECT_TRUE(estimate.lost);
  EXPECT_LT(estimate.probability, 0.8);
  ASSERT_FALSE(estimate.alternatives.empty());
  EXPECT_GT(estimate.alternatives[0].share, 0.2);
  const SE2 twin = distance(estimate.T_map_base, truth) < 0.2 ? estimate.alternatives[0].T_map_base
                                                              : estimate.T_map_base;
  EXPECT_LT(distance(twin, {7.0, 5.0, 0.0}), 0.2);
}

TEST(MhAmcl, FindsOutThatAPlaceNearByWasALookAlike) {
  // A kidnap happens during a scan. Half a metre from the original pose the room then looks almost
  // the same, except for a box.
  OccupancyGrid room = test::office();
  test::fill(room, 0.2, 0.2, 9.8, 7.8, CellState::kFree);
  test::fill(room, 2.0, 6.0, 2.2, 6.2, CellState::kOccupied);
  const SE2 look_alike{7.0, 5.0, 0.3 - std::numbers::pi};
  const SE2 before = look_alike * SE2{-0.4, 0.3, 0.3};
  MhAmcl localizer({}, room, 1);
  localizer.initialize(known_start(before));
  test::GridDrive drive(room, before);
  for (int i = 0; i < 10; ++i) drive.step(localizer, {});
  ASSERT_FALSE(localizer.estimate()->lost);
  drive.step_torn(localizer, {}, {3.0, 3.0, 0.3});
  for (int i = 0; i < 80; ++i) drive.step(localizer, {0.02, 0.0, 0.03});
  EXPECT_TRUE(is_right(localizer, drive.truth()));
}

TEST(MhAmcl, RepeatsItselfBitForBit) {
  const auto run = [](std::uint64_t seed) {
    MhAmcl localizer({}, test::office(), seed);
    test::GridDrive drive(test::office(), kStart);
    for (int i = 0; i < 15; ++i) drive.step(localizer, kForward);
    return localizer.estimate()->T_map_base;
  };
  EXPECT_EQ(run(3), run(3));
  EXPECT_NE(run(3), run(4));
}

TEST(MhAmcl, DropsWhatItCannotUseAndCountsIt) {
  MhAmcl localizer({}, test::office(), 1);
  localizer.on_scan(test::scan_at(test::office(), kStart, Stamp(0)));  // no odometry yet
  EXPECT_EQ(localizer.diagnostics().dropped_scans, 1);
  test::GridDrive drive(test::office(), kStart);
  drive.step(localizer, {});
  drive.step(localizer, {});
  localizer.on_scan(test::scan_at(test::office(), kStart, Stamp(std::chrono::milliseconds(50))));
  EXPECT_EQ(localizer.diagnostics().dropped_scans, 2);
  EXPECT_TRUE(localizer.estimate());
}

TEST(MhAmcl, SurvivesScansWithoutReturnsAndMapsWithoutWalls) {
  MhAmcl localizer({}, test::office(), 1);
  localizer.initialize(known_start(kStart));
  localizer.on_odometry({Stamp(1), {}});
  LaserScan blind = test::scan_at(test::office(), kStart, Stamp(1));
  blind.ranges.assign(blind.ranges.size(), std::numeric_limits<float>::quiet_NaN());
  localizer.on_scan(blind);
  ASSERT_TRUE(localizer.estimate());
  EXPECT_LT(distance(localizer.estimate()->T_map_base, kStart), 0.2);

  OccupancyGrid empty = test::office();
  empty.cells.assign(empty.cells.size(), CellState::kFree);
  MhAmcl nowhere({}, empty, 1);
  test::GridDrive drive(test::office(), kStart);
  for (int i = 0; i < 5; ++i) drive.step(nowhere, kForward);
  EXPECT_TRUE(!nowhere.estimate() || nowhere.estimate()->lost);
}

TEST(MhAmcl, ReportsItsPopulationsAndTheCostOfItsStages) {
  std::chrono::nanoseconds time{};
  MhAmcl localizer({}, test::office(), 1, [&time] { return time += std::chrono::nanoseconds(5); });
  localizer.initialize(known_start(kStart));
  test::GridDrive drive(test::office(), kStart);
  for (int i = 0; i < 3; ++i) drive.step(localizer, kForward);
  const Diagnostics diagnostics = localizer.diagnostics();
  ASSERT_EQ(diagnostics.populations.size(), 1U);
  EXPECT_TRUE(diagnostics.populations[0].selected);
  EXPECT_GE(diagnostics.populations[0].particles.size(), 50U);
  EXPECT_EQ(diagnostics.cpu_by_stage.at("correct").count(), 3 * 5);
}

/// Stated probabilities of a robot at rest that is found by a search with the first scan.
std::vector<double> probabilities_at_rest(double usual_rate) {
  MhAmclConfig config;
  config.create.deep_below = -1000.0;  // The quick search is the only one.
  config.posterior.null.usual_rate = usual_rate;
  config.posterior.null.usual_match_rate = 0.0;  // Searches do not change the usual likelihood.
  MhAmcl localizer(config, test::office(), 1);
  test::GridDrive drive(test::office(), kStart);
  std::vector<double> probabilities;
  for (int i = 0; i < 2; ++i) {
    drive.step(localizer, {});
    probabilities.push_back(localizer.estimate()->probability);
  }
  return probabilities;
}

/// An average that goes to an observation with a rate of 2 overshoots by as much as it was off; if
/// it took the same observation twice, it would be back where it was.
TEST(MhAmcl, LearnsOfAScanOnceThoughASearchEndsWithIt) {
  const std::vector<double> unlearned = probabilities_at_rest(0.0);
  const std::vector<double> learned = probabilities_at_rest(2.0);
  EXPECT_GT(learned[0], 0.9);  // confident enough to learn
  EXPECT_EQ(learned[0], unlearned[0]);
  EXPECT_GT(std::abs(learned[1] - unlearned[1]), 1e-6);
}

TEST(MhAmcl, RefusesSettingsThatMakeNoSense) {
  MhAmclConfig config;
  config.input.correct_rate_hz = 0.0;
  EXPECT_THROW(MhAmcl(config, test::office(), 1), std::invalid_argument);
  config = {};
  config.match.slice = 0;
  EXPECT_THROW(MhAmcl(config, test::office(), 1), std::invalid_argument);
  config = {};
  config.lost_and_found.found = 1.1;
  EXPECT_THROW(MhAmcl(config, test::office(), 1), std::invalid_argument);
  config = {};
  config.match.confident = 0.0;
  EXPECT_THROW(MhAmcl(config, test::office(), 1), std::invalid_argument);
  EXPECT_THROW(MhAmcl({}, OccupancyGrid{}, 1), std::invalid_argument);
}

}  // namespace
}  // namespace castaway::localization
