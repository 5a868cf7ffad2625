/// Builds scan points for tests.
#pragma once

#include <initializer_list>

#include "localization/sensor/scan_points.hpp"
#include "tests/support/grid_world.hpp"

namespace castaway::test {

/// Beams straight ahead of base with these ranges [m].
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

/// Points in base of a scan taken at a pose by a lidar at the origin of base.
inline localization::ScanPoints points_from(const OccupancyGrid& grid, const SE2& T_map_base) {
  localization::TransformBuffer buffer;
  buffer.add(localization::Stamp(0), {});
  const localization::LaserScan scan = scan_at(grid, T_map_base, localization::Stamp(0));
  return *localization::project_scan(scan, buffer, localization::Stamp(0), {});
}

/// Shortens a third of the beams, on one side, to 1 m, as if people stood there.
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
