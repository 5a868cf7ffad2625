#include "tools/twin/log_fit.hpp"

#include <gtest/gtest.h>

#include "tests/tools/support/recorded_office.hpp"

namespace castaway::testbed {
namespace {

constexpr float kBehind = std::numeric_limits<float>::infinity();

/// The map with all walls thicker by a cell: surfaces lie a cell behind the borders.
RosMap thick_walls(const RosMap& map) {
  RosMap thick = map;
  for (int row = 1; row + 1 < map.height; ++row) {
    for (int column = 1; column + 1 < map.width; ++column) {
      const bool near = map.at(column - 1, row) == 100 || map.at(column + 1, row) == 100 ||
                        map.at(column, row - 1) == 100 || map.at(column, row + 1) == 100;
      if (near) thick.cells[static_cast<std::size_t>(row * map.width + column)] = 100;
    }
  }
  return thick;
}

/// The log of the office with a lidar that looks ahead.
RecordedPlace office_ahead(int scans) {
  RecordedPlace place = recorded_office(scans);
  for (Frame& frame : place.frames) {
    auto* scan = std::get_if<ScanFrame>(&frame.data);
    if (scan == nullptr) continue;
    for (std::size_t i = 0; i < scan->scan.ranges.size(); ++i) {
      if (std::cos(scan->scan.beam_angle(i)) < 0.0) scan->scan.ranges[i] = kBehind;
    }
  }
  return place;
}

// Walls that are taken for farther behind their borders, and a lidar for farther ahead, fit as
// well.
TEST(LogFit, LeavesALidarThatLooksAheadWhereItIs) {
  RecordedPlace place = office_ahead(200);
  place.map = thick_walls(place.map);
  const FittedLog fitted = fit_log(place, {.align = AlignBy::kTruth, .track = 0.3});
  double ahead = 0.0;
  std::size_t k = 0;
  for (const Frame& frame : place.frames) {
    const auto* scan = std::get_if<ScanFrame>(&frame.data);
    if (scan == nullptr) continue;
    ahead += (scan->true_pose->T_map_base.inverse() * fitted.log.scans.at(k++).T_map_base).x;
  }
  ASSERT_EQ(k, 200U);
  EXPECT_NEAR(ahead / 200.0, 0.0, 0.02);
}

}  // namespace
}  // namespace castaway::testbed
