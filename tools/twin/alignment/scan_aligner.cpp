#include "tools/twin/alignment/scan_aligner.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "localization/map/hollow.hpp"
#include "tools/twin/alignment/expected_scan.hpp"

namespace castaway::testbed {
namespace {

constexpr double kFieldReach = 1.0;  // [m]

}  // namespace

ScanAligner::ScanAligner(const AlignedLog& log, std::optional<WallOffsets> walls)
    : log_(log),
      walls_(std::move(walls)),
      distances_(localization::hollow(log.grid, 0.0), kFieldReach),
      model_({.sigma = 0.05, .floor = 0.05, .independent_beams = 40.0}, distances_) {}

std::optional<SE2> ScanAligner::align(const LaserScan& scan, const SE2& start, double sigma) const {
  const auto points = project_scan(walls_ ? move_to_centres(scan, start) : scan, log_.T_path_base,
                                   scan.stamp, {.max_beams = 180, .max_range = 40.0});
  if (!points || points->empty()) return std::nullopt;
  const double yaw_sigma = 0.4 * sigma;
  Eigen::Vector3d information(sigma, sigma, yaw_sigma);
  information = information.array().square().inverse();
  const localization::PosePrior prior{start, information.asDiagonal()};
  return refine_pose(model_, *points, start, prior, {0.04, 0.01, 6});
}

double ScanAligner::on_walls(const AlignedScan& aligned) const {
  constexpr double kNear = 0.2;  // [m]
  const auto points = project_scan(aligned.scan, log_.T_path_base, aligned.scan.stamp,
                                   {.max_beams = 90, .max_range = 40.0});
  if (!points || points->empty()) return 0.0;
  const SE2 T_grid_base = log_.grid.frame.T_map_grid.inverse() * aligned.T_map_base;
  double near = 0.0;
  for (std::size_t i = 0; i < points->size(); ++i) {
    const Eigen::Vector2d p = T_grid_base * Eigen::Vector2d(points->x[i], points->y[i]);
    if (distances_.at(p) < kNear) near += 1.0;
  }
  return near / static_cast<double>(points->size());
}

/// The scan with its end points moved from the surfaces of walls to the centres of their cells.
LaserScan ScanAligner::move_to_centres(LaserScan scan, const SE2& T_map_base) const {
  constexpr double kLeastCosine = 0.3;
  const double half = 0.5 * log_.grid.frame.resolution;
  const std::vector<ExpectedBeam> expected =
      expect_scan(log_, {scan, T_map_base}, std::min(scan.range_max, 40.0));
  for (std::size_t i = 0; i < scan.ranges.size(); ++i) {
    double shift = half - walls_->usual();
    if (i < expected.size() && expected[i].straight) {
      shift = (half - walls_->at(expected[i].cell)) /
              std::max<double>(expected[i].cosine, kLeastCosine);
    }
    scan.ranges[i] += static_cast<float>(shift);
  }
  return scan;
}

}  // namespace castaway::testbed
