#include "sim/navigation/passing.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "sim/map/grid_tools.hpp"

namespace castaway::sim {
namespace {

const Lane kLane{{0.0, 0.0}, {1.5, 0.0}};

/// A corridor along x, centred at y = 0.
FreeSpace corridor(double half_width) {
  Grid grid;
  grid.resolution = 0.05;
  grid.width = 400;
  grid.height = 120;
  grid.origin = {-5.0, -3.0};
  grid.cells.assign(400 * 120, Cell::kFree);
  for (int row = 0; row < grid.height; ++row) {
    for (int column = 0; column < grid.width; ++column) {
      const double y = center_of(grid, {column, row}).y();
      if (std::abs(y) > half_width) grid.cells[flat_index(grid, {column, row})] = Cell::kOccupied;
    }
  }
  return FreeSpace(grid, 0.25);
}

Mover coming(double x, double y) { return {{x, y}, {-1.3, 0.0}}; }

TEST(Passing, KeepsToTheRightWhereThereIsRoom) {
  EXPECT_NEAR(Passing({}).choose_target(kLane, 0.8, {}, corridor(1.5)).y(), -0.4, 1e-9);
  EXPECT_NEAR(Passing({}).choose_target(kLane, 0.8, {}, corridor(0.5)).y(), 0.0, 1e-9);
}

TEST(Passing, LeavesRoomOnTheSideWhereThePersonIsNot) {
  const FreeSpace space = corridor(1.5);
  EXPECT_LT(Passing({}).choose_target(kLane, 0.8, {coming(4.0, 0.2)}, space).y(), -0.5);
  EXPECT_GT(Passing({}).choose_target(kLane, 0.8, {coming(4.0, -0.9)}, space).y(), -0.1);
}

TEST(Passing, DoesNotMindWhoIsBehindFarOffOrFaster) {
  const FreeSpace space = corridor(1.5);
  const std::vector<Mover> others{coming(-1.5, -0.4), coming(7.0, -0.4), {{2.0, -0.4}, {1.5, 0.0}}};
  EXPECT_NEAR(Passing({}).choose_target(kLane, 0.8, others, space).y(), -0.4, 1e-9);
}

TEST(Passing, ReachesTheLanesEnd) {
  const Lane end{{0.0, 0.0}, {0.5, 0.0}};
  EXPECT_EQ(Passing({}).choose_target(end, 0.8, {coming(2.0, 0.0)}, corridor(1.5)), end.to);
}

TEST(Passing, LeavesWhoStandsToTheDynamicWindow) {
  EXPECT_NEAR(Passing({}).choose_target(kLane, 0.8, {{{2.0, -0.4}, {0.0, 0.0}}}, corridor(1.5)).y(),
              -0.4, 1e-9);
}

const PaceConfig kPace{.max_speed = 0.9, .deceleration = 0.5, .radius = 0.25};

double pace(const std::vector<Mover>& movers, double offset = 0.0) {
  return passing_pace(kPace, kLane, offset, movers);
}

TEST(PassingPace, IsFullWithNobodyAbout) {
  EXPECT_EQ(pace({}), 0.9);
  EXPECT_EQ(pace({coming(9.0, 0.0)}), 0.9);
}

/// A robot that a person walks towards at 1.3 m/s has stopped before the person arrives: braking
/// takes v / a.
TEST(PassingPace, LetsTheRobotStandByTheTimeThatSomebodyIsThere) {
  for (const double gap : {1.5, 2.0, 3.0, 4.0}) {
    const double v = pace({coming(gap, 0.0)});
    const double way = 0.5 * v * v / kPace.deceleration + 1.3 * v / kPace.deceleration;
    EXPECT_LE(way, gap - kPace.radius - kMoverRadius) << gap;
    EXPECT_GT(v, 0.0) << gap;
    EXPECT_LT(v, 0.9) << gap;
  }
  EXPECT_EQ(pace({coming(0.8, 0.0)}), 0.0);
}

TEST(PassingPace, FallsAsWhoIsBesideTheWayComesNearer) {
  EXPECT_NEAR(pace({coming(3.0, 1.0)}), 0.525, 1e-9);
  EXPECT_NEAR(pace({coming(1.0, 1.0)}), 0.2, 1e-9);
  EXPECT_NEAR(pace({coming(3.0, 0.4)}, -0.5), 0.525, 1e-9);  // By the robot's course.
  EXPECT_EQ(pace({coming(3.0, 1.4)}), 0.9);
  EXPECT_EQ(pace({coming(-1.0, 0.0)}), 0.9);
}

TEST(PassingPace, MindsWhoWalksIntoTheWay) {
  const Mover crossing{{1.2, 1.1}, {-0.3, -1.0}};
  EXPECT_LT(pace({crossing}), 0.4);
}

TEST(PassingPace, LetsWhoOvertakesCutIn) {
  EXPECT_EQ(pace({{{-0.3, 0.5}, {1.4, -0.6}}}), 0.0);
  EXPECT_EQ(pace({{{-0.3, 1.0}, {1.4, 0.0}}}), 0.9);
  EXPECT_EQ(pace({{{-1.0, 0.0}, {1.4, 0.0}}}), 0.9);
}

TEST(PassingPace, FollowsAtADistanceThatIsEnoughToStopIn) {
  EXPECT_EQ(pace({{{5.5, 0.0}, {1.4, 0.0}}}), 0.9);
  EXPECT_LT(pace({{{3.0, 0.0}, {0.6, 0.0}}}), 0.7);  // They may turn towards the robot.
  EXPECT_NEAR(pace({{{1.5, 0.0}, {0.6, 0.0}}}), 0.3, 1e-9);
  EXPECT_EQ(pace({{{0.7, 0.0}, {0.6, 0.0}}}), 0.0);
}

TEST(PassingPace, IsCarefulBeforeWhoStandsButPasses) {
  const Mover stands{{1.0, 0.2}, {0.0, 0.0}};
  EXPECT_NEAR(pace({stands}), 0.3, 1e-9);
  EXPECT_EQ(pace({{{1.0, 1.0}, {0.0, 0.0}}}), 0.9);
}

}  // namespace
}  // namespace castaway::sim
