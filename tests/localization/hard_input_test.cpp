// Late, malformed or mismatched input has defined results and never crashes a localizer. Every test
// runs with every localizer.
#include <algorithm>
#include <functional>
#include <limits>
#include <memory>
#include <ostream>
#include <stdexcept>

#include <gtest/gtest.h>

#include "localization/amcl/amcl.hpp"
#include "localization/mh_amcl/mh_amcl.hpp"
#include "localization/paper/paper_mh_amcl.hpp"
#include "tests/support/grid_drive.hpp"

namespace castaway::localization {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;
using test::kForward;
using test::known_start;
using test::kStart;

/// A kind of localizer.
struct Kind {
  std::string name;
  std::function<std::unique_ptr<Localizer>(const OccupancyGrid&)> make;
};

void PrintTo(const Kind& kind, std::ostream* out) { *out << kind.name; }

Kind mh_amcl() {
  return {"improved", [](const OccupancyGrid& map) {
            return std::make_unique<MhAmcl>(MhAmclConfig{}, map, 1);
          }};
}

Kind paper() {
  return {"paper", [](const OccupancyGrid& map) {
            return std::make_unique<PaperMhAmcl>(PaperMhAmclConfig{}, map, 1);
          }};
}

Kind amcl(const std::string& name, AmclSensorModel model) {
  return {name, [model](const OccupancyGrid& map) {
            AmclConfig config;
            config.model = model;
            return std::make_unique<Amcl>(config, map, 1);
          }};
}

double error(const Localizer& localizer, const SE2& truth) {
  const auto estimate = localizer.estimate();
  return estimate ? distance(estimate->T_map_base, truth) : 1e9;
}

class HardInput : public testing::TestWithParam<Kind> {
 protected:
  void start_at(const SE2& pose) { localizer_->initialize(known_start(pose)); }
  void drive(test::GridDrive& drive, int steps) {
    for (int i = 0; i < steps; ++i) drive.step(*localizer_, kForward);
  }
  OccupancyGrid office_ = test::office();
  std::unique_ptr<Localizer> localizer_ = GetParam().make(office_);
};

TEST_P(HardInput, LateScansAreDroppedWithACount) {
  start_at(kStart);
  test::GridDrive office(office_, kStart);
  drive(office, 5);
  const Estimate before = *localizer_->estimate();
  localizer_->on_scan(test::scan_at(office_, kStart, office.now() - milliseconds(50)));
  localizer_->on_scan(test::scan_at(office_, kStart, office.now()));
  EXPECT_EQ(localizer_->diagnostics().dropped_scans, 2);
  EXPECT_EQ(localizer_->estimate()->stamp, before.stamp);
  drive(office, 5);
  EXPECT_LT(error(*localizer_, office.truth()), 0.2);
}

TEST_P(HardInput, LateAndBrokenOdometryIsDroppedWithACount) {
  start_at(kStart);
  test::GridDrive office(office_, kStart);
  drive(office, 5);
  localizer_->on_odometry({office.now() - milliseconds(5), {99.0, 0.0, 0.0}});
  localizer_->on_odometry(
      {office.now() + milliseconds(5), {std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0}});
  EXPECT_EQ(localizer_->diagnostics().dropped_odometry, 2);
  drive(office, 5);
  EXPECT_LT(error(*localizer_, office.truth()), 0.2);
}

TEST_P(HardInput, NumbersThatNoRobotReachesAreDroppedWithACount) {
  start_at(kStart);
  test::GridDrive office(office_, kStart);
  drive(office, 5);
  for (const double huge : {1e300, -1e12, std::numeric_limits<double>::infinity()}) {
    localizer_->on_odometry({office.now() + milliseconds(5), {huge, 0.0, 0.0}});
    LaserScan scan = test::scan_at(office_, kStart, office.now() + milliseconds(5));
    scan.T_base_laser.translation().y() = huge;
    localizer_->on_scan(scan);
  }
  EXPECT_EQ(localizer_->diagnostics().dropped_odometry, 3);
  EXPECT_EQ(localizer_->diagnostics().dropped_scans, 3);
  EXPECT_THROW(localizer_->initialize(known_start({1e300, 0.0, 0.0})), std::invalid_argument);
  drive(office, 5);
  EXPECT_LT(error(*localizer_, office.truth()), 0.2);
}

TEST_P(HardInput, RangesAndAnglesOfAnySizeAreSurvived) {
  start_at(kStart);
  test::GridDrive office(office_, kStart);
  drive(office, 5);
  LaserScan scan = test::scan_at(office_, kStart, office.now() + milliseconds(5));
  scan.range_max = 1e300;
  for (float& range : scan.ranges) range = 3e38F;
  localizer_->on_odometry({scan.stamp, {0.0, 0.0, 1e300}});
  localizer_->on_scan(scan);
  localizer_->initialize(known_start(kStart));
  EXPECT_TRUE(std::isfinite(localizer_->estimate()->T_map_base.x));
}

TEST_P(HardInput, AGapOfOdometryIsBridged) {
  start_at(kStart);
  test::GridDrive office(office_, kStart);
  drive(office, 5);
  // 3 s and 0.6 m without data.
  office.skip(seconds(3), {0.6, 0.0, 0.0});
  drive(office, 15);
  EXPECT_LT(error(*localizer_, office.truth()), 0.25);
}

TEST_P(HardInput, AClockSetBackBeginsANewMotionAtTheSamePlace) {
  start_at(kStart);
  test::GridDrive office(office_, kStart);
  office.skip(seconds(10), {});
  drive(office, 10);
  // The log starts again: stamps from 0, odometry from its own origin.
  test::GridDrive again(office_, office.truth());
  drive(again, 15);
  EXPECT_LT(error(*localizer_, again.truth()), 0.2);
  EXPECT_EQ(localizer_->diagnostics().dropped_scans, 0);
}

TEST_P(HardInput, AClockSetAheadChangesNothing) {
  start_at(kStart);
  test::GridDrive office(office_, kStart);
  drive(office, 5);
  office.skip(std::chrono::hours(10), {});
  drive(office, 10);
  EXPECT_LT(error(*localizer_, office.truth()), 0.2);
}

TEST_P(HardInput, ScansWithoutAnythingToSeeAreHarmless) {
  start_at(kStart);
  test::GridDrive office(office_, kStart);
  drive(office, 5);
  const float inf = std::numeric_limits<float>::infinity();
  for (const float r : {std::numeric_limits<float>::quiet_NaN(), inf, -inf, 0.0F, -1.0F, 1e30F}) {
    office.step_blind(*localizer_, kForward, r);
    ASSERT_TRUE(localizer_->estimate());
  }
  LaserScan none;
  none.stamp = office.now() + milliseconds(1);
  localizer_->on_scan(none);
  drive(office, 10);
  EXPECT_LT(error(*localizer_, office.truth()), 0.25);
}

TEST_P(HardInput, MapsWithoutWallsGiveNoConfidentWrongAnswer) {
  OccupancyGrid empty = office_;
  std::fill(empty.cells.begin(), empty.cells.end(), CellState::kFree);
  localizer_ = GetParam().make(empty);
  test::GridDrive office(office_, kStart);
  drive(office, 15);
  const auto estimate = localizer_->estimate();
  EXPECT_LT(estimate ? estimate->probability : 0.0, 0.9);
}

TEST_P(HardInput, AStartOffTheMapIsSurvived) {
  start_at({-500.0, 1e6, 1.0});
  test::GridDrive office(office_, kStart);
  drive(office, 10);
  localizer_->initialize(known_start(office.truth()));
  drive(office, 10);
  EXPECT_LT(error(*localizer_, office.truth()), 0.2);
}

TEST_P(HardInput, AStartThatIsNoNumberIsRefusedAndChangesNothing) {
  start_at(kStart);
  test::GridDrive office(office_, kStart);
  drive(office, 5);
  EXPECT_THROW(
      localizer_->initialize(known_start({std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0})),
      std::invalid_argument);
  drive(office, 5);
  EXPECT_LT(error(*localizer_, office.truth()), 0.2);
}

TEST_P(HardInput, TheUserCanSayWhereItIsAtAnyTime) {
  start_at({7.5, 6.5, 2.0});  // a wrong pose
  test::GridDrive office(office_, kStart);
  drive(office, 3);
  localizer_->initialize(known_start(office.truth()));
  drive(office, 5);
  EXPECT_LT(error(*localizer_, office.truth()), 0.2);
}

TEST_P(HardInput, GlobalLocalizationCanBeAskedForAtAnyTime) {
  start_at(kStart);
  test::GridDrive office(office_, kStart);
  drive(office, 5);
  localizer_->initialize(std::nullopt);
  EXPECT_FALSE(localizer_->estimate());
  drive(office, 5);  // its pose may be wrong, but it does not crash, and a user can correct it
  localizer_->initialize(known_start(office.truth()));
  drive(office, 5);
  EXPECT_LT(error(*localizer_, office.truth()), 0.2);
}

TEST_P(HardInput, TwoLidarsShareTheView) {
  start_at(kStart);
  test::GridDrive office(office_, kStart);
  for (int i = 0; i < 30; ++i) office.step_two_lidars(*localizer_, kForward);
  EXPECT_LT(error(*localizer_, office.truth()), 0.15);
  EXPECT_EQ(localizer_->diagnostics().dropped_scans, 0);
}

TEST(HardMaps, WithoutAFreeCellGiveNoEstimateOrAreRefused) {
  OccupancyGrid unknown = test::office();
  std::fill(unknown.cells.begin(), unknown.cells.end(), CellState::kUnknown);
  MhAmcl localizer({}, unknown, 1);
  test::GridDrive office(test::office(), kStart);
  for (int i = 0; i < 10; ++i) office.step(localizer, kForward);
  EXPECT_FALSE(localizer.estimate());
  EXPECT_THROW(Amcl({}, unknown, 1), std::invalid_argument);
}

INSTANTIATE_TEST_SUITE_P(Localizers, HardInput,
                         testing::Values(mh_amcl(), paper(),
                                         amcl("amcl", AmclSensorModel::kLikelihoodField),
                                         amcl("amcl_prob", AmclSensorModel::kLikelihoodFieldProb),
                                         amcl("amcl_beam", AmclSensorModel::kBeam)),
                         [](const auto& kind) { return kind.param.name; });

}  // namespace
}  // namespace castaway::localization
