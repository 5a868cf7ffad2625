// Runs on two floors: from a world's file to the truth in frames.
#include <algorithm>

#include <gtest/gtest.h>

#include "tests/tools/support/temporary.hpp"
#include "tools/build/build_simulation.hpp"
#include "tools/build/simulator_source.hpp"
#include "tools/run/event_names.hpp"

namespace castaway::testbed {
namespace {

/// A hall with a platform at 1.5 m and a ramp of 15 % that leads up to it.
constexpr const char* kTwoFloors = R"(name: two-floors
extent: {min: [0, 0], max: [20, 8]}
start: [1, 6, 0]
levels: true
objects:
  - wall: {points: [[0.1, 0.1], [19.9, 0.1], [19.9, 7.9], [0.1, 7.9]], closed: true, height: 4}
  - box: {name: platform, at: [15.5, 3], size: [6, 5, 0.2], bottom: 1.3, drivable: true}
  - ramp: {name: up, at: [7.5, 3], size: [10, 2, 1.5]}
routes: {hall: [[1, 6], [14, 7]]}
)";

class Levels : public testing::Test {
 protected:
  Levels() {
    folder_.put("w.yaml", kTwoFloors);
    scenario_.world.file = "w.yaml";
    scenario_.duration_s = 90.0;
    scenario_.drive.route = "random";
  }

  PreparedSimulation build() { return build_simulation(scenario_, folder_.path()); }

  /// The message of the error when the run is built.
  std::string error() {
    try {
      build_source(scenario_, build().config);
    } catch (const std::exception& error) {
      return error.what();
    }
    return {};
  }

  TemporaryFolder folder_;
  Scenario scenario_;
};

TEST_F(Levels, TheRobotDrivesUpAndStaysOnTheGround) {
  const auto source = build_source(scenario_, build().config);
  double highest = 0.0;
  double highest_by_odometry = 0.0;
  double steepest = 0.0;
  while (const auto frame = source->next()) {
    if (const auto* event = std::get_if<RunEvent>(&frame->data)) {
      ADD_FAILURE() << names_of(event->what).kind << ' ' << names_of(event->what).detail;
    }
    if (const auto* odometry = std::get_if<OdometryFrame>(&frame->data)) {
      ASSERT_TRUE(odometry->true_pose->T_footprint_base);
      highest_by_odometry =
          std::max(highest_by_odometry, odometry->true_pose->T_footprint_base->translation().z());
    }
    const auto* scan = std::get_if<ScanFrame>(&frame->data);
    if (scan == nullptr) continue;
    ASSERT_TRUE(scan->true_pose->T_footprint_base);
    const Eigen::Isometry3d& T_footprint_base = *scan->true_pose->T_footprint_base;
    highest = std::max(highest, T_footprint_base.translation().z());
    steepest = std::max(steepest, std::acos(std::min(1.0, T_footprint_base.linear()(2, 2))));
    EXPECT_GT(T_footprint_base.translation().z(), -0.02);
  }
  EXPECT_NEAR(highest, 1.5, 0.02);
  EXPECT_NEAR(highest_by_odometry, 1.5, 0.02);
  EXPECT_NEAR(steepest, std::atan(0.15), 0.03);
}

TEST_F(Levels, KidnapsSayFromWhichHeightToWhich) {
  scenario_.duration_s = 50.0;
  scenario_.events.simulated.kidnaps = {
      {.when = {.value = 1.0}, .level = 1},
      {.kind = sim::KidnapKind::kElevator, .when = {.value = 5.0}, .lift = {0.01, 6.0, 1.0}},
      {.kind = sim::KidnapKind::kPalletTruck, .when = {.value = 15.0}, .level = 1}};
  const auto source = build_source(scenario_, build().config);
  std::vector<RunEvent> kidnaps;
  std::vector<double> after;  // Heights of the first scans.
  while (const auto frame = source->next()) {
    if (const auto* event = std::get_if<RunEvent>(&frame->data)) {
      if (event->is<KidnapEvent>()) kidnaps.push_back(*event);
    }
    const auto* scan = std::get_if<ScanFrame>(&frame->data);
    if (scan != nullptr && after.size() < kidnaps.size()) {
      after.push_back(scan->true_pose->T_footprint_base->translation().z());
    }
  }
  ASSERT_EQ(kidnaps.size(), 3U);
  const auto heights = [&](std::size_t i) { return kidnaps[i].as<KidnapEvent>()->heights.value(); };
  EXPECT_NEAR(heights(0).y(), 1.5, 0.02);
  EXPECT_NEAR(heights(1).x(), 1.5, 0.02);
  EXPECT_NEAR(heights(1).y(), 0.0, 0.02);
  EXPECT_NEAR(seconds(kidnaps[1].stamp - *kidnaps[1].since), 6.0, 0.01);
  EXPECT_NEAR(heights(2).y(), 1.5, 0.02);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(after[i], heights(i).y(), 0.05);
}

TEST_F(Levels, AStartMayBeAboveOrAtRandom) {
  scenario_.start.place = StartSpec::Place::kPose;
  scenario_.start.pose = {15.0, 3.0, 0.5};
  EXPECT_NEAR(build_source(scenario_, build().config)->start_height(), 0.0, 1e-3);
  scenario_.start.level = 1;
  const auto source = build_source(scenario_, build().config);
  EXPECT_NEAR(source->start_height(), 1.5, 0.02);
  EXPECT_NEAR(source->start_pose()->x, 15.0, 1e-9);
  EXPECT_NEAR(source->start_pose()->y, 3.0, 1e-9);
  scenario_.start.pose = {1.0, 1.0, 0.5};
  EXPECT_EQ(error(), "start: no ground at (1, 1) on its level: move it");
}

/// A robot on the platform neither touches nor avoids people below.
TEST_F(Levels, PeopleWalkOnTheLowestFloor) {
  scenario_.people.config.walking = 8;
  scenario_.events.simulated.kidnaps = {{.when = {.value = 1.0}, .level = 1}};
  scenario_.drive.route = "none";
  const auto source = build_source(scenario_, build().config);
  double below = 1e9;  // [m] Least distance as seen from above.
  double least_gap = 1e9;
  while (const auto frame = source->next()) {
    const auto* event = std::get_if<RunEvent>(&frame->data);
    if (event != nullptr) {
      EXPECT_TRUE(event->is<KidnapEvent>());
    }
    const auto* scan = std::get_if<ScanFrame>(&frame->data);
    if (scan == nullptr || seconds(frame->stamp) < 1.5) continue;
    ASSERT_EQ(scan->people.people.size(), 8U);
    for (const PersonTruth& person : scan->people.people) {
      below = std::min(below, distance(person.T_map_person, scan->true_pose->T_map_base));
      least_gap = std::min(least_gap, person.gap_m);
    }
  }
  EXPECT_LT(below, 1.5);
  EXPECT_GT(least_gap, 5.0);
}

TEST_F(Levels, TheSameSeedGivesTheSameRun) {
  scenario_.duration_s = 10.0;
  const auto poses = [this] {
    const auto source = build_source(scenario_, build().config);
    std::vector<double> numbers;
    while (const auto frame = source->next()) {
      const auto* scan = std::get_if<ScanFrame>(&frame->data);
      if (scan == nullptr) continue;
      const Eigen::Matrix4d matrix = scan->true_pose->T_footprint_base->matrix();
      numbers.insert(numbers.end(), matrix.data(), matrix.data() + 16);
      numbers.push_back(scan->true_pose->T_map_base.x);
    }
    return numbers;
  };
  const std::vector<double> first = poses();
  EXPECT_FALSE(first.empty());
  EXPECT_EQ(first, poses());
}

TEST_F(Levels, WhatIsPlannedForOneFloorIsRefused) {
  const Scenario good = scenario_;
  scenario_.people.config.walking = 1;
  scenario_.people.config.blocked_share = 0.2;
  EXPECT_EQ(error(), "a world with `levels: true` has no crowds yet: leave people.crowd out");
  scenario_ = good;
  scenario_.kinematic = true;
  EXPECT_EQ(error(), "a world with `levels: true` has no kinematic robots: use physics");
  scenario_ = good;
  scenario_.drive.by = "mh_amcl";
  EXPECT_EQ(
      error(),
      "a world with `levels: true` has no navigation by estimates yet: set drive.by to truth");
  scenario_ = good;
  scenario_.events.simulated.kidnaps = {
      {.kind = sim::KidnapKind::kLookAlike, .when = {.value = 1.0}}};
  EXPECT_EQ(error(), "kidnap look_alike: not on several levels: choose another kind");
  scenario_.events.simulated.kidnaps = {{.when = {.value = 1.0}, .level = 3}};
  EXPECT_EQ(error(), "kidnap at 1 s: no free place on level 3; the world has levels 0 to 1");
  scenario_ = good;
  scenario_.world.file = "lab";
  scenario_.drive.route = "";
  scenario_.events.simulated.kidnaps = {
      {.kind = sim::KidnapKind::kElevator, .when = {.value = 1.0}}};
  EXPECT_EQ(error(), "kidnap at 1 s: an elevator needs a world with `levels: true`");
  scenario_.events.simulated.kidnaps.clear();
  scenario_.start.level = 1;
  EXPECT_EQ(error(), "start.level: the world has one level: leave it out");
}

}  // namespace
}  // namespace castaway::testbed
