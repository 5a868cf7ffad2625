#include "localization/space/map3d/survey_ground.hpp"

#include <gtest/gtest.h>

namespace castaway::localization {
namespace {

/// A row of cells of 1 m: three at 0, four at 3 m.
ElevationMap two_parts() {
  ElevationMap map;
  map.frame = {7, 1, 1.0, {}};
  map.first.push_back(0);
  for (int i = 0; i < 7; ++i) {
    map.surfaces.push_back({i < 3 ? 0.0F : 3.0F, 0.0F, 0.0F, 9.0F, 0, true});
    map.first.push_back(static_cast<std::uint32_t>(i + 1));
  }
  map.levels = {0.0F};
  return map;
}

std::vector<bool> drivable(const ElevationMap& map) {
  std::vector<bool> flags;
  for (const GroundSurface& surface : map.surfaces) flags.push_back(surface.drivable);
  return flags;
}

const std::vector<bool> kLow{true, true, true, false, false, false, false};
const std::vector<bool> kHigh{false, false, false, true, true, true, true};

TEST(KeepReachable, LeavesWhatIsConnectedWithTheStart) {
  ElevationMap map = two_parts();
  keep_reachable(map, Eigen::Vector3d(1.4, 0.5, 0.1), 0.05);
  EXPECT_EQ(drivable(map), kLow);
}

TEST(KeepReachable, WithoutAStartTheLargestPart) {
  ElevationMap map = two_parts();
  keep_reachable(map, std::nullopt, 0.05);
  EXPECT_EQ(drivable(map), kHigh);
  map = two_parts();
  keep_reachable(map, Eigen::Vector3d(1.4, 0.5, 1.5), 0.05);  // On no ground.
  EXPECT_EQ(drivable(map), kHigh);
}

TEST(KeepReachable, WhatIsNotDrivableStaysSo) {
  ElevationMap map = two_parts();
  for (GroundSurface& surface : map.surfaces) surface.drivable = false;
  keep_reachable(map, std::nullopt, 0.05);
  EXPECT_EQ(drivable(map), std::vector<bool>(7, false));
}

}  // namespace
}  // namespace castaway::localization
