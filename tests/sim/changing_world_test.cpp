// Worlds that change during a run.
#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "sim/common/seconds.hpp"
#include "sim/map/rasterise.hpp"
#include "sim/simulation.hpp"
#include "sim/world/door.hpp"
#include "tests/sim/support/frame_hash.hpp"
#include "tests/sim/support/happenings.hpp"
#include "tests/sim/support/test_people.hpp"
#include "tests/sim/support/test_world.hpp"

namespace castaway::sim {
namespace {

using std::chrono::seconds;

const Pose2 kBeforeTheShelf{1.0, -1.0, 0.0};

SimulationStreams changing_streams() {
  SimulationStreams streams = test_streams(3);
  streams.named = named_streams(3);
  return streams;
}

/// The robot stands, with a wall 3 m ahead of it.
SimulationConfig before_a_wall() {
  SimulationConfig config = test_simulation();
  config.drive.waypoints.clear();
  config.start = kBeforeTheShelf;
  config.duration = seconds(4);
  return config;
}

WorldChange box_event(double at_s, const Eigen::Vector2d& center, double edge = 0.4) {
  WorldChange change;
  change.at_s = at_s;
  change.what = PutObject{box_on_floor("crate", {edge, edge, 0.8}, center)};
  return change;
}

WorldChange people_event(double at_s, const AddPeople& arrival) {
  WorldChange change;
  change.at_s = at_s;
  change.what = arrival;
  return change;
}

std::vector<SimFrame> play_changing(SimulationConfig config) {
  Simulation simulation(std::move(config), changing_streams());
  std::vector<SimFrame> frames;
  while (auto frame = simulation.next()) frames.push_back(std::move(*frame));
  return frames;
}

template <typename Data>
std::vector<Data> data_of(const std::vector<SimFrame>& frames) {
  std::vector<Data> found;
  for (const SimFrame& frame : frames) {
    if (const auto* data = std::get_if<Data>(&frame.data)) found.push_back(*data);
  }
  return found;
}

/// What the beam straight ahead of the robot measures in the scan at `at_s`.
struct Ahead {
  float range;
  int object;
};

Ahead ahead_at(const std::vector<SimFrame>& frames, double at_s) {
  for (const LidarReading& scan : data_of<LidarReading>(frames)) {
    if (to_seconds(scan.stamp) < at_s - 1e-9) continue;
    const LidarConfig lidar;
    const auto beam =
        static_cast<std::size_t>(std::lround(-lidar.angle_min / lidar.angle_increment));
    return {scan.ranges[beam], scan.hit_object[beam]};
  }
  throw std::logic_error("no scan at this time");
}

TEST(ChangingWorld, LidarsSeeAnObjectFromItsTimeOnUntilItIsTakenAway) {
  SimulationConfig config = before_a_wall();
  const auto crate = static_cast<int>(config.world.objects.size());
  WorldChange take;
  take.at_s = 2.0;
  take.what = TakeObject{"crate"};
  config.events.changes = {take, box_event(1.0, {2.2, -1.0})};
  const std::vector<SimFrame> frames = play_changing(config);
  const Ahead before = ahead_at(frames, 0.5);
  const Ahead with = ahead_at(frames, 1.5);
  const Ahead after = ahead_at(frames, 2.5);
  EXPECT_NEAR(before.range - with.range, 2.0, 1e-3);  // From the wall at x = 4 m to x = 2 m.
  EXPECT_EQ(with.object, crate);
  EXPECT_EQ(after.range, before.range);
  EXPECT_EQ(after.object, before.object);
  const auto records = happenings_of<WorldNews>(frames);
  ASSERT_EQ(records.size(), 2U);
  EXPECT_EQ(records[0].stamp, seconds(1));
  const auto& put = std::get<WorldNews>(records[0].what);
  EXPECT_EQ(std::get<WorldNews::Put>(put.what).name, "crate");
  EXPECT_EQ(put.outline.size(), 4U);
  EXPECT_EQ(put.z, Eigen::Vector2d(0.0, 0.8));
  const auto& taken = std::get<WorldNews>(records[1].what);
  EXPECT_EQ(std::get<WorldNews::Take>(taken.what).name, "crate");
  EXPECT_TRUE(taken.outline.empty());
}

TEST(ChangingWorld, ARobotRunsIntoWhatWasPutBeforeIt) {
  for (const DriveModel model : {DriveModel::kPhysics, DriveModel::kKinematic}) {
    SimulationConfig config = before_a_wall();
    config.drive_model = model;
    config.events.commands = {{0.0, Twist2{0.5, 0.0}}};
    config.events.changes = {box_event(0.5, {2.4, -1.0})};
    Simulation simulation(config, changing_streams());
    while (simulation.next()) {
    }
    EXPECT_GE(simulation.collisions(), 1);
    EXPECT_LT(simulation.true_pose().x, 2.2);
    EXPECT_GT(simulation.true_pose().x, 1.6);
  }
}

TEST(ChangingWorld, ANewObjectElsewhereDoesNotDisturbPhysics) {
  SimulationConfig config = before_a_wall();
  config.events.commands = {{0.0, Twist2{0.3, 0.4}}};
  const auto poses = [](const std::vector<SimFrame>& frames) {
    Hash hash;
    for (const auto& reading : data_of<OdometryReading>(frames)) hash.add(reading.T_map_base_true);
    return hash.value();
  };
  const std::uint64_t alone = poses(play_changing(config));
  config.events.changes = {box_event(1.0, {-3.5, 2.5})};
  EXPECT_EQ(poses(play_changing(config)), alone);
}

TEST(ChangingWorld, ARouteLeadsAroundWhatWasPutThere) {
  SimulationConfig config = test_simulation();
  config.duration = seconds(30);
  config.events.changes = {box_event(1.0, {1.0, -1.6}, 0.6)};  // On the way to the first waypoint.
  Simulation simulation(config, changing_streams());
  while (simulation.next()) {
  }
  EXPECT_EQ(simulation.collisions(), 0);
  EXPECT_FALSE(simulation.void_record());
  EXPECT_GT(simulation.distance_driven(), 5.0);
}

TEST(ChangingWorld, NothingIsPutOntoARobot) {
  SimulationConfig config = test_simulation();
  config.events.changes = {box_event(0.0, config.start.position())};
  const auto records = happenings_of<WorldNews>(play_changing(config));
  ASSERT_EQ(records.size(), 1U);  // Once the robot has left.
  EXPECT_GT(records[0].stamp, std::chrono::milliseconds(500));
  const double away = (records[0].T_map_base.position() - config.start.position()).norm();
  EXPECT_GT(away, 0.2 + config.robot.footprint_radius);
  EXPECT_LT(away, 1.0);
}

/// Two rooms and a door between them, which is open.
SimulationConfig rooms_with_door() {
  SimulationConfig config = test_simulation();
  config.world.objects.resize(4);  // The walls.
  Door door;
  door.name = "door";
  door.T_map_hinge = Eigen::Translation3d(0.0, -0.6, 0.0) *
                     Eigen::AngleAxisd(0.5 * 3.14159265358979, Eigen::Vector3d::UnitZ());
  door.leaf = {1.2, 0.04, 1.9};
  door.open_deg = 90.0;
  config.world.doors = {door};
  config.world.objects.push_back(door_leaf(door, 90.0));
  config.world.objects.push_back(box_on_floor("wall-1", {0.1, 2.4, 1.9}, {0.0, -1.8}));
  config.world.objects.push_back(box_on_floor("wall-2", {0.1, 2.4, 1.9}, {0.0, 1.8}));
  config.map = rasterise(config.world, 0.2, 0.05);
  config.start = {-2.0, -2.0, 0.0};
  config.drive.waypoints = {{3.0, 2.0}, {-3.0, 2.0}, {-3.0, -2.0}};
  config.duration = seconds(60);
  return config;
}

WorldChange door_event(double at_s, double open_deg) {
  WorldChange change;
  change.at_s = at_s;
  change.what = TurnDoor{"door", open_deg};
  return change;
}

double farthest_east(const std::vector<SimFrame>& frames, seconds from) {
  double x = -1e9;
  for (const OdometryReading& reading : data_of<OdometryReading>(frames)) {
    if (reading.stamp >= from) x = std::max(x, reading.T_map_base_true.x);
  }
  return x;
}

TEST(ChangingWorld, NobodyPassesADoorThatIsClosed) {
  for (const DriveModel model : {DriveModel::kPhysics, DriveModel::kKinematic}) {
    SimulationConfig config = rooms_with_door();
    config.drive_model = model;
    EXPECT_GT(farthest_east(play_changing(config), seconds(0)), 2.5);
    config.events.changes = {door_event(0.5, 0.0)};
    Simulation simulation(config, changing_streams());
    std::vector<SimFrame> frames;
    while (auto frame = simulation.next()) frames.push_back(std::move(*frame));
    EXPECT_LT(farthest_east(frames, seconds(0)), 0.0);
    EXPECT_FALSE(simulation.void_record()) << "it goes on to the next waypoint";
    EXPECT_GT(simulation.distance_driven(), 8.0);
    config.events.changes.push_back(door_event(20.0, 90.0));
    EXPECT_GT(farthest_east(play_changing(config), seconds(20)), 2.5);
  }
}

TEST(ChangingWorld, ARobotInAClosedRoomDrivesInIt) {
  SimulationConfig config = rooms_with_door();
  config.world.objects[5].T_map_object.translation().x() = 2.0;  // The walls: a small room.
  config.world.objects[6].T_map_object.translation().x() = 2.0;
  config.world.doors[0].T_map_hinge.translation().x() = 2.0;
  config.world.objects[4] = door_leaf(config.world.doors[0], 90.0);
  config.map = rasterise(config.world, 0.2, 0.05);
  config.start = {3.0, -2.0, 1.5};
  config.drive.waypoints = {{3.0, 2.0}, {3.0, -2.0}};
  config.events.changes = {door_event(0.5, 0.0)};
  Simulation simulation(config, changing_streams());
  while (simulation.next()) {
  }
  EXPECT_EQ(simulation.collisions(), 0);
  EXPECT_GT(simulation.distance_driven(), 15.0);
}

TEST(ChangingWorld, PeopleCome) {
  SimulationConfig config = before_a_wall();
  AddPeople walkers{{-2.5, 1.5, 0.0}, 3, true};
  config.events.changes = {people_event(1.0, {{2.5, -1.0, 1.0}}), people_event(2.0, walkers)};
  const auto scans = data_of<LidarReading>(play_changing(config));
  EXPECT_TRUE(scans[5].people.empty());
  ASSERT_EQ(scans[15].people.size(), 1U);
  EXPECT_NEAR(scans[15].people[0].T_map_person.x, 2.5, 0.05);
  EXPECT_NEAR(scans[15].people[0].T_map_person.yaw, 1.0, 0.05);
  const auto first = scans[21].people;
  const auto later = scans[38].people;
  ASSERT_EQ(later.size(), 4U);
  for (std::size_t i = 1; i < 4; ++i) {
    const Eigen::Vector2d way = later[i].T_map_person.position() - first[i].T_map_person.position();
    EXPECT_GT(way.norm(), 0.3) << i;
    EXPECT_LT(way.norm(), 4.0) << i;
  }
  EXPECT_TRUE(std::ranges::any_of(scans[15].hit_object, is_person));
}

TEST(ChangingWorld, PeopleInAClosedRoomStayInIt) {
  SimulationConfig config = rooms_with_door();
  config.drive.waypoints.clear();
  config.start = {-3.5, -2.5, 0.0};
  AddPeople walker{{2.0, -1.5, 0.0}, 1, true};
  config.events.changes = {door_event(0.0, 0.0)};
  for (int i = 0; i < 4; ++i) {
    walker.T_map_person.y = -2.0 + i;
    config.events.changes.push_back(people_event(0.5, walker));
  }
  const auto scans = data_of<LidarReading>(play_changing(config));
  double walked = 0.0;
  for (std::size_t i = 1; i < scans.size(); ++i) {
    for (std::size_t k = 0; k < scans[i - 1].people.size(); ++k) {
      const Eigen::Vector2d p = scans[i].people[k].T_map_person.position();
      EXPECT_GT(p.x(), 0.2);
      walked += (p - scans[i - 1].people[k].T_map_person.position()).norm();
    }
  }
  EXPECT_EQ(scans.back().people.size(), 4U);
  EXPECT_GT(walked, 10.0);
}

TEST(ChangingWorld, AChangeThatIsAddedEqualsOneThatIsConfigured) {
  const std::vector<WorldChange> changes{box_event(0.0, {-3.5, 2.4}), door_event(0.0, 0.0),
                                         people_event(0.0, {{2.0, -2.0, 0.0}, 2, true})};
  for (const WorldChange& change : changes) {
    SimulationConfig config = rooms_with_door();
    config.duration = seconds(8);
    config.events.kidnaps = {{.when = {.value = 5.0}}};
    config.events.changes = {box_event(7.0, {3.0, -2.5})};  // To come: the new one goes before it.
    std::get<PutObject>(config.events.changes[0].what).object.name = "late";
    SimulationConfig open = config;
    open.open = true;
    Simulation simulation(open, changing_streams());
    std::vector<SimFrame> frames;
    double at_s = 0.0;
    while (auto frame = simulation.next()) {
      frames.push_back(std::move(*frame));
      if (at_s > 0.0 || simulation.now() < seconds(2)) continue;
      WorldChange now = change;
      now.at_s = at_s = to_seconds(simulation.now());
      simulation.add(now);
      config.events.changes.push_back(now);
    }
    EXPECT_EQ(hash_of(frames), hash_of(play_changing(config))) << change.what.index();
    EXPECT_NE(hash_of(frames), hash_of(play_changing(open))) << change.what.index();
  }
}

TEST(ChangingWorld, WhatIsAddedInOneStepHasRoomBesideEachOther) {
  SimulationConfig config = rooms_with_door();
  config.open = true;
  Simulation simulation(config, changing_streams());
  simulation.add(people_event(0.0, {{2.0, 2.0, 0.0}}));
  EXPECT_THROW(simulation.add(box_event(0.0, {2.0, 2.0})), std::invalid_argument);
  EXPECT_THROW(simulation.add(people_event(0.0, {{2.1, 2.0, 0.0}})), std::invalid_argument);
  EXPECT_NO_THROW(simulation.add(box_event(0.0, {3.0, 2.0})));
  EXPECT_EQ(simulation.people().size(), 1U);
}

TEST(ChangingWorld, RefusesWhatIsImpossible) {
  SimulationConfig config = rooms_with_door();
  config.open = true;
  Simulation simulation(config, changing_streams());
  const auto refuses = [&](const WorldChange& change) {
    EXPECT_THROW(simulation.add(change), std::invalid_argument) << change.what.index();
  };
  refuses(box_event(0.0, config.start.position()));        // On the robot.
  refuses(people_event(0.0, {{0.0, 2.0, 0.0}}));           // In a wall.
  refuses(people_event(0.0, {{2.0, 2.0, 0.0}, 5, true}));  // Too large a group.
  WorldChange change = door_event(0.0, 0.0);
  std::get<TurnDoor>(change.what).name = "gate";
  refuses(change);
  change.what = TakeObject{"south"};  // A wall on the map.
  refuses(change);
  change = box_event(0.0, {2.0, 2.0});
  std::get<PutObject>(change.what).object.name = "south";
  refuses(change);
  config.events.changes = {change};
  EXPECT_THROW(Simulation(config, changing_streams()), std::invalid_argument);
}

}  // namespace
}  // namespace castaway::sim
