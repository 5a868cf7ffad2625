#include "localization/paper/published/published_match.hpp"

namespace castaway::localization {

PaperCascade published_cascade(PaperCascadeConfig config, const RayLocalConfig& sensor,
                               const OccupancyGrid& grid, const PublishedDefects& defects) {
  constexpr int kCoarseLevel = 2;  // Cells of 4 x 4.
  if (defects.wide_headings) config.yaw_step = std::numbers::pi / 4.0;
  if (defects.one_coarse_level) {
    config.finest_level = kCoarseLevel;
    config.levels = kCoarseLevel + 1;
  }
  return {config, sensor, grid,
          defects.transposed_search ? CellFilter(is_in_transposed_search) : CellFilter()};
}

bool is_in_transposed_search(const GridFrame& frame, int column, int row) {
  const Eigen::Vector2d origin = frame.T_map_grid.translation();
  const Eigen::Vector2d cell = origin + frame.resolution * Eigen::Vector2d(column, row);
  const Eigen::Vector2d end =
      origin + frame.resolution * Eigen::Vector2d(frame.width, frame.height);
  return cell.x() < end.y() && cell.y() < end.x();
}

ScanPoints points_at_base(const MatchScan& scan, const BeamSelection& beams) {
  LaserScan unmounted = scan.scan;
  unmounted.T_base_laser.setIdentity();
  return project_scan(unmounted, scan.T_odom_base, scan.turn.now, beams).value();
}

}  // namespace castaway::localization
