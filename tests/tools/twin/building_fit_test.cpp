#include "tools/twin/fits/building_fit.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "tests/tools/twin/room_log.hpp"

namespace castaway::testbed {
namespace {

constexpr double kTooNear = std::numbers::pi * 1.5 * 1.5;  // [m^2] around the robot, not watched

using localization::CellState;
using localization::OccupancyGrid;
using std::chrono::milliseconds;

constexpr double kRoomArea = 7.6 * 5.6;  // [m^2]
constexpr float kThroughAll = std::numeric_limits<float>::infinity();

/// A rectangle in the grid's frame. [m]
struct Rectangle {
  double x0 = 0.0;
  double y0 = 0.0;
  double x1 = 0.0;
  double y1 = 0.0;
};

/// The room with things in it, as a building.
OccupancyGrid room_with(const std::vector<Rectangle>& things) {
  OccupancyGrid grid = room_grid();
  for (const Rectangle& r : things) test::fill(grid, r.x0, r.y0, r.x1, r.y1, CellState::kOccupied);
  return grid;
}

/// A person seen from above: a square of 0.4 m whose corners are corners of cells.
Rectangle person_at(double x, double y) {
  const auto snap = [](double value) { return 0.05 * std::round(value / 0.05); };
  return {snap(x) - 0.2, snap(y) - 0.2, snap(x) + 0.2, snap(y) + 0.2};
}

/// Adds a scan of a building to a log. Its beams end 1 cm behind the surfaces, within their cells.
void add_scan_of(const OccupancyGrid& building, const SE2& T_grid_base, AlignedLog& log) {
  const SE2 T_map_base = log.grid.frame.T_map_grid * T_grid_base;
  const auto stamp = milliseconds(100 * log.scans.size());
  log.scans.push_back({room_scan(building, T_map_base, stamp), T_map_base});
  for (float& r : log.scans.back().scan.ranges) r += 0.01F;
}

/// Scans of a building from a round in the room, at least 0.6 m from its walls.
AlignedLog round_log(const OccupancyGrid& map, const OccupancyGrid& building, int scans) {
  AlignedLog log = standing_log(map);
  for (int k = 0; k < scans; ++k) {
    const double angle = 2.0 * std::numbers::pi * k / scans;
    add_scan_of(building, {4.0 + 3.2 * std::cos(angle), 3.0 + 2.2 * std::sin(angle), 0.3 * k}, log);
  }
  return log;
}

/// People walk around the middle of the room at 1.5 m/s, evenly spread. The robot turns there so
/// that the gap between its last beam and its first stays `seam` [rad] behind the first person.
AlignedLog crowded_log(int people, double seam, int scans = 60) {
  constexpr double kRadius = 2.2;  // [m]
  constexpr double kStep = 0.15;   // [m] Between scans.
  AlignedLog log = standing_log(room_grid());
  for (int k = 0; k < scans; ++k) {
    const double first = k * kStep / kRadius;
    std::vector<Rectangle> bodies;
    for (int person = 0; person < people; ++person) {
      const double angle = first + 2.0 * std::numbers::pi * person / people;
      bodies.push_back(person_at(4.0 + kRadius * std::cos(angle), 3.0 + kRadius * std::sin(angle)));
    }
    add_scan_of(room_with(bodies), {4.0, 3.0, first - seam + std::numbers::pi}, log);
  }
  return log;
}

/// The same with the seam half way between two people.
AlignedLog crowded_log(int people) {
  return crowded_log(people, std::numbers::pi / std::max(people, 1));
}

/// Share of the beams of a log that are by `more` [m] longer than the map says, or by -`more`
/// shorter.
double share_off_the_map(const AlignedLog& log, double more) {
  double count = 0.0;
  double beams = 0.0;
  for (const AlignedScan& aligned : log.scans) {
    const LaserScan expected = room_scan(log.grid, aligned.T_map_base);
    for (std::size_t i = 0; i < expected.ranges.size(); ++i) {
      const double off = aligned.scan.ranges[i] - expected.ranges[i];
      beams += 1.0;
      if (more > 0.0 ? off > more : off < more) count += 1.0;
    }
  }
  return count / beams;
}

/// The box is a rectangle of the grid's frame.
void expect_box(const MapBox& box, const AlignedLog& log, const Rectangle& r) {
  const SE2 T_grid_box = log.grid.frame.T_map_grid.inverse() * box.T_map_box;
  EXPECT_NEAR(T_grid_box.x, 0.5 * (r.x0 + r.x1), 1e-9);
  EXPECT_NEAR(T_grid_box.y, 0.5 * (r.y0 + r.y1), 1e-9);
  EXPECT_NEAR(T_grid_box.yaw, 0.0, 1e-9);
  EXPECT_NEAR(box.size.x(), r.x1 - r.x0, 1e-9);
  EXPECT_NEAR(box.size.y(), r.y1 - r.y0, 1e-9);
}

void expect_as_on_the_map(const BuildingFit& fit) {
  for (const Figure& figure :
       {fit.moving_share, fit.standing_share, fit.through_share, fit.moving_count}) {
    EXPECT_EQ(figure.value, 0.0);
    EXPECT_EQ(figure.interval.low, 0.0);
    EXPECT_EQ(figure.interval.high, 0.0);
  }
  EXPECT_TRUE(fit.standing.empty());
  EXPECT_TRUE(fit.gone.empty());
}

TEST(BuildingFit, OfAnEmptyRoomShowsNothing) {
  const auto fit = fit_building(room_log(60));
  ASSERT_TRUE(fit);
  expect_as_on_the_map(*fit);
  EXPECT_EQ(fit->beams, 60U * 360U);
  EXPECT_NEAR(fit->free_area_m2, kRoomArea, 1e-9);
}

TEST(BuildingFit, WatchesTheRoomAsFarAsItIsSeen) {
  const auto from_the_middle = fit_building(crowded_log(0));
  ASSERT_TRUE(from_the_middle);
  EXPECT_NEAR(from_the_middle->watched_m2, kRoomArea - kTooNear, 0.01 * kRoomArea);
  AlignedLog corner = standing_log(room_grid());
  for (int k = 0; k < 12; ++k) add_scan_of(corner.grid, {0.25, 0.25, 0.0}, corner);
  // A quarter of a ring from 1.5 m to 6 m, less what is beyond the upper wall.
  const double above = std::acos(5.55 / 6.0);
  const double segment = 0.5 * 36.0 * above - 0.5 * 5.55 * std::sqrt(36.0 - 5.55 * 5.55);
  EXPECT_NEAR(fit_building(corner)->watched_m2, 9.0 * std::numbers::pi - 0.25 * kTooNear - segment,
              0.5);
}

TEST(BuildingFit, FindsABoxThatStandsAtItsPlaceAndInItsSize) {
  const Rectangle box{3.6, 2.7, 4.4, 3.1};
  const AlignedLog log = round_log(room_grid(), room_with({box}), 60);
  const auto fit = fit_building(log);
  ASSERT_TRUE(fit);
  ASSERT_EQ(fit->standing.size(), 1U);
  expect_box(fit->standing[0], log, box);
  EXPECT_NEAR(fit->standing_share.value, share_off_the_map(log, -0.25), 0.002);
  EXPECT_LT(fit->moving_share.value, 0.002);  // beams that graze a corner
  EXPECT_EQ(fit->through_share.value, 0.0);
  EXPECT_TRUE(fit->gone.empty());
}

TEST(BuildingFit, KeepsBoxesApart) {
  const std::vector<Rectangle> boxes = {{2.5, 2.0, 2.9, 2.3}, {4.0, 3.5, 4.5, 3.7}};
  const AlignedLog log = round_log(room_grid(), room_with(boxes), 80);
  const auto fit = fit_building(log);
  ASSERT_TRUE(fit);
  ASSERT_EQ(fit->standing.size(), 2U);
  expect_box(fit->standing[0], log, boxes[0]);
  expect_box(fit->standing[1], log, boxes[1]);
}

TEST(BuildingFit, FindsABoxFromASweepingLidarOnAMovingRobot) {
  const Rectangle box{3.6, 2.7, 4.4, 3.1};
  const OccupancyGrid building = room_with({box});
  AlignedLog log = standing_log(room_grid());
  log.T_path_base = localization::TransformBuffer({.length = std::chrono::hours(1)});
  const localization::SE2 T_base_laser{0.2, -0.1, 0.5 * std::numbers::pi};
  constexpr int kScans = 60;
  constexpr double kSpeed = 2.0;  // [m/s] 0.2 m in a scan.
  for (int k = 0; k <= 3 * kScans; ++k) {
    log.T_path_base.add(milliseconds(100 * k), SE2{0.1 * kSpeed * k, 0.0, 0.0});
  }
  for (int k = 0; k < kScans; ++k) {
    const double angle = 2.0 * std::numbers::pi * k / kScans;
    const SE2 T_grid_base{4.0 + 2.8 * std::cos(angle), 3.0 + 1.8 * std::sin(angle), 0.3 * k};
    AlignedScan aligned;
    aligned.T_map_base = log.grid.frame.T_map_grid * T_grid_base;
    aligned.scan = room_scan(building, aligned.T_map_base, milliseconds(200 * k));
    aligned.scan.time_increment = std::chrono::nanoseconds(100'000'000 / 360);
    aligned.scan.T_base_laser = localization::to_se3(T_base_laser);
    for (std::size_t i = 0; i < aligned.scan.ranges.size(); ++i) {
      const double way =
          kSpeed * testbed::seconds(aligned.scan.time_increment) * static_cast<double>(i);
      const SE2 T_grid_laser = T_grid_base * SE2{way, 0.0, 0.0} * T_base_laser;
      const double heading = T_grid_laser.yaw + aligned.scan.beam_angle(i);
      const double cells =
          localization::cast_ray(building, T_grid_laser.translation() / 0.05,
                                 {std::cos(heading), std::sin(heading)}, 12.0 / 0.05);
      aligned.scan.ranges[i] = static_cast<float>(0.05 * cells + 0.01);
    }
    log.scans.push_back(aligned);
  }
  const auto fit = fit_building(log);
  ASSERT_TRUE(fit);
  ASSERT_EQ(fit->standing.size(), 1U);
  expect_box(fit->standing[0], log, box);
}

TEST(BuildingFit, TakesReturnsNearAWallAsTheWalls) {
  const auto fit = fit_building(round_log(room_grid(), room_with({{3.0, 0.0, 4.0, 0.4}}), 60));
  ASSERT_TRUE(fit);
  expect_as_on_the_map(*fit);
}

TEST(BuildingFit, APersonWhoWalksIsMoving) {
  const AlignedLog log = crowded_log(1);
  const auto fit = fit_building(log);
  ASSERT_TRUE(fit);
  EXPECT_DOUBLE_EQ(fit->moving_share.value, share_off_the_map(log, -0.25));
  EXPECT_GT(fit->moving_share.value, 0.02);
  EXPECT_EQ(fit->standing_share.value, 0.0);
  EXPECT_EQ(fit->through_share.value, 0.0);
  EXPECT_TRUE(fit->standing.empty());
  EXPECT_TRUE(fit->gone.empty());
  EXPECT_NEAR(fit->moving_count.value, fit->free_area_m2 / fit->watched_m2, 1e-9);
  EXPECT_NEAR(fit->moving_count.value, kRoomArea / (kRoomArea - kTooNear), 0.1);
}

TEST(BuildingFit, CountsEveryoneWhoMoves) {
  double before = 0.0;
  for (int people = 1; people <= 5; ++people) {
    const auto fit = fit_building(crowded_log(people));
    ASSERT_TRUE(fit);
    const double count = people * fit->free_area_m2 / fit->watched_m2;
    EXPECT_NEAR(fit->moving_count.value, count, 1e-9) << people;
    EXPECT_GT(fit->moving_count.value, before + 0.9);
    EXPECT_TRUE(fit->standing.empty());
    before = fit->moving_count.value;
  }
}

TEST(BuildingFit, CountsSomebodyOnceWhomTheLastBeamsAndTheFirstSee) {
  const auto fit = fit_building(crowded_log(3, 0.0));
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->moving_count.value, 3.0 * fit->free_area_m2 / fit->watched_m2, 1e-9);
}

TEST(BuildingFit, CountsNobodyWhoIsNearTheRobotOrFarAway) {
  AlignedLog log = standing_log(room_grid());
  for (int k = 0; k < 60; ++k) {
    const double y = 1.0 + 4.0 * k / 60.0;
    const Rectangle near = person_at(1.8, 3.0 + 0.6 * std::sin(0.3 * k));
    const Rectangle far = person_at(7.2, y);
    add_scan_of(room_with({k % 2 == 0 ? near : far}), {0.8, 3.0, 0.0}, log);
  }
  const auto fit = fit_building(log);
  ASSERT_TRUE(fit);
  EXPECT_EQ(fit->moving_count.value, 0.0);
  EXPECT_GT(fit->moving_share.value, 0.01);
}

TEST(BuildingFit, ABoxStandsIfItWasThereMostOfTheTime) {
  const Rectangle box{3.6, 2.7, 4.4, 3.1};
  for (const int every : {2, 6}) {
    AlignedLog log = standing_log(room_grid());
    for (int k = 0; k < 60; ++k) {
      const OccupancyGrid building = k % every == 0 ? room_with({box}) : room_grid();
      add_scan_of(building, {1.5, 3.0, 0.0}, log);
    }
    const auto fit = fit_building(log);
    ASSERT_TRUE(fit);
    EXPECT_EQ(fit->standing.size(), every == 2 ? 1U : 0U);
    EXPECT_EQ(fit->standing_share.value > 0.0, every == 2);
    EXPECT_EQ(fit->moving_share.value > 0.0, every == 6);
  }
}

TEST(BuildingFit, AWallThatIsGoneAppearsInGone) {
  const Rectangle wall{3.95, 2.2, 4.05, 3.8};
  const AlignedLog log = round_log(room_with({wall}), room_grid(), 60);
  const auto fit = fit_building(log);
  ASSERT_TRUE(fit);
  ASSERT_EQ(fit->gone.size(), 1U);
  const SE2 T_grid_box = log.grid.frame.T_map_grid.inverse() * fit->gone[0].T_map_box;
  EXPECT_NEAR(T_grid_box.x, 4.0, 0.05);
  EXPECT_NEAR(T_grid_box.y, 3.0, 0.05);
  EXPECT_NEAR(fit->gone[0].size.x(), 0.1, 0.101);
  EXPECT_NEAR(fit->gone[0].size.y(), 1.6, 0.101);
  EXPECT_NEAR(fit->through_share.value, share_off_the_map(log, 0.5), 1e-4);
  EXPECT_GT(fit->through_share.value, 0.05);
  EXPECT_EQ(fit->moving_share.value, 0.0);
  EXPECT_TRUE(fit->standing.empty());
}

TEST(BuildingFit, OnlyCellsOfWallsAreGone) {
  const Rectangle wall{3.95, 2.2, 4.05, 3.8};
  const AlignedLog log = round_log(room_with({wall}), room_grid(), 60);
  const auto fit = fit_building(log);
  ASSERT_TRUE(fit);
  ASSERT_EQ(fit->gone.size(), 1U);
  expect_box(fit->gone[0], log, wall);
}

TEST(BuildingFit, OnlyTheOpenPartOfAWallIsGone) {
  const Rectangle wall{3.95, 1.5, 4.05, 4.5};
  const AlignedLog log =
      round_log(room_with({wall}), room_with({{3.95, 1.5, 4.05, 2.5}, {3.95, 3.5, 4.05, 4.5}}), 80);
  const auto fit = fit_building(log);
  ASSERT_TRUE(fit);
  ASSERT_EQ(fit->gone.size(), 1U);
  const SE2 T_grid_box = log.grid.frame.T_map_grid.inverse() * fit->gone[0].T_map_box;
  EXPECT_NEAR(T_grid_box.x, 4.0, 1e-9);
  EXPECT_NEAR(T_grid_box.y, 3.0, 0.05);
  EXPECT_NEAR(fit->gone[0].size.y(), 1.0, 0.101);
}

TEST(BuildingFit, ADoorIsGoneIfItWasOpenMostOfTheTime) {
  const OccupancyGrid closed = room_with({{3.95, 2.5, 4.05, 3.5}});
  for (const int every : {2, 6}) {
    AlignedLog log = standing_log(closed);
    for (int k = 0; k < 60; ++k) {
      add_scan_of(k % every == 0 ? closed : room_grid(), {1.5, 3.0, 0.0}, log);
    }
    const auto fit = fit_building(log);
    ASSERT_TRUE(fit);
    EXPECT_EQ(fit->gone.size(), every == 6 ? 1U : 0U);
    EXPECT_GT(fit->through_share.value, 0.0);
  }
}

TEST(BuildingFit, AWallThatAPersonHidesIsNotGone) {
  const auto fit = fit_building(crowded_log(4));
  ASSERT_TRUE(fit);
  EXPECT_TRUE(fit->gone.empty());
}

TEST(BuildingFit, CountsTheFreeSpaceThatTheRobotReaches) {
  OccupancyGrid map = room_with({{5.0, 0.0, 5.2, 6.0}});
  test::fill(map, 0.2, 0.2, 1.2, 5.8, CellState::kUnknown);
  AlignedLog log = standing_log(map);
  for (int k = 0; k < 12; ++k) add_scan_of(map, {3.0, 3.0, 0.0}, log);
  const auto fit = fit_building(log);
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->free_area_m2, (5.0 - 1.2) * 5.6, 1e-9);
}

TEST(BuildingFit, BeamsWithoutReturnShowNothing) {
  AlignedLog log = room_log(24);
  for (AlignedScan& aligned : log.scans) aligned.scan.ranges.assign(360, kThroughAll);
  const auto fit = fit_building(log);
  ASSERT_TRUE(fit);
  expect_as_on_the_map(*fit);
  EXPECT_EQ(fit->beams, 24U * 360U);
}

TEST(BuildingFit, NeedsBeamsOfKnownRange) {
  AlignedLog log = room_log(24);
  for (const float invalid : {std::numeric_limits<float>::quiet_NaN(), -kThroughAll, 0.01F}) {
    for (AlignedScan& aligned : log.scans) aligned.scan.ranges.assign(360, invalid);
    EXPECT_FALSE(fit_building(log));
  }
}

/// People at places that are drawn anew for each scan, 1.7 to 2.4 m from the robot.
AlignedLog scattered_log(int people, int scans) {
  localization::Rng rng = localization::substream(1, "people");
  boost::random::uniform_real_distribution<double> radius(1.7, 2.4);
  boost::random::uniform_real_distribution<double> angle(-std::numbers::pi, std::numbers::pi);
  AlignedLog log = standing_log(room_grid());
  for (int k = 0; k < scans; ++k) {
    std::vector<Rectangle> bodies;
    for (int person = 0; person < people; ++person) {
      const double r = radius(rng);
      const double a = angle(rng);
      bodies.push_back(person_at(4.0 + r * std::cos(a), 3.0 + r * std::sin(a)));
    }
    add_scan_of(room_with(bodies), {4.0, 3.0, 0.0}, log);
  }
  return log;
}

// Nobody stands closer than 1.5 m, where nobody is counted: the rest of the room is more crowded.
// Two people count as one if one hides the other or they are within a stride: closer than 0.65 rad
// to either side, a stride and a body at 1.7 m. That is at most 0.21 of all pairs.
TEST(BuildingFit, CountsPeopleWhoAppearAnywhere) {
  constexpr int kScans = 240;
  for (const int people : {1, 2, 3}) {
    const auto fit = fit_building(scattered_log(people, kScans));
    ASSERT_TRUE(fit);
    const double pairs = 0.5 * people * (people - 1);
    const double sigma = std::sqrt(0.21 * 0.79 * pairs / kScans);
    EXPECT_GT(fit->moving_count.value, people - 0.21 * pairs - 4.0 * sigma);
    EXPECT_LT(fit->moving_count.value, 1.15 * people * kRoomArea / (kRoomArea - kTooNear));
    EXPECT_LE(fit->moving_count.interval.low, fit->moving_count.value);
    EXPECT_GE(fit->moving_count.interval.high, fit->moving_count.value);
  }
}

}  // namespace
}  // namespace castaway::testbed
