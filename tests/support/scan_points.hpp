/// Scans as points, for tests.
#pragma once

#include <initializer_list>

#include "localization/sensor/scan_points.hpp"
#include "tests/support/grid_world.hpp"

namespace castaway::test {

/// Beams straight ahead of base, of these ranges. [m]
inline localization::ScanPoints forward_beams(std::initializer_list<float> ranges) {
  localization::ScanPoints points;
  for (const float r : ranges) {
    points.x.push_back(r);
    points.y.push_back(0.0F);
    points.z.push_back(0.0F);
    points.origin_x.push_back(0.0F);
    points.origin_y.push_back(0.0F);
    points.origin_z.push_back(0.0F);
    points.range.push_back(r);
  }
  return points;
}

/// What a lidar in the centre of base sees from a pose, in base.
inline localization::ScanPoints points_from(const OccupancyGrid& grid, const SE2& T_map_base) {
  localization::TransformBuffer buffer;
  buffer.add(localization::Stamp(0), {});
  const localization::LaserScan scan = scan_at(grid, T_map_base, localization::Stamp(0));
  return *localization::project_scan(scan, buffer, localization::Stamp(0), {});
}

/// The same with people all around on one side: their beams end a metre from the robot.
inline localization::ScanPoints with_people(localization::ScanPoints points) {
  for (std::size_t i = 0; i < points.size() / 3; ++i) {
    const float scale = 1.0F / points.range[i];
    points.x[i] *= scale;
    points.y[i] *= scale;
    points.range[i] = 1.0F;
  }
  return points;
}

}  // namespace castaway::test
