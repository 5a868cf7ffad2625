#include "tools/twin/alignment/beam_view.hpp"

#include <algorithm>
#include <cmath>

namespace castaway::testbed {
namespace {

constexpr double kLongestView = 20.0;  // [m]
constexpr double kOffWall = 0.25;      // [m] Returns closer to a wall are the wall's.

}  // namespace

BeamViewer::BeamViewer(const AlignedLog& log) : log_(log), distances_(log.grid, 1.0) {}

std::vector<BeamView> BeamViewer::view(const AlignedScan& aligned) const {
  const LaserScan& scan = aligned.scan;
  const double longest = std::min(scan.range_max, kLongestView);
  const std::vector<ExpectedBeam> expected = expect_scan(log_, aligned, longest);
  std::vector<BeamView> views;
  for (std::size_t i = 0; i < expected.size(); ++i) {
    const float r = scan.ranges[i];
    if (std::isnan(r) || r < scan.range_min) continue;
    views.push_back(view_of(aligned, i, expected[i], std::min<double>(r, longest)));
  }
  return views;
}

BeamView BeamViewer::view_of(const AlignedScan& aligned, std::size_t i, const ExpectedBeam& beam,
                             double r) const {
  const LaserScan& scan = aligned.scan;
  const localization::GridFrame& frame = log_.grid.frame;
  BeamView view;
  view.returns = r < std::min(scan.range_max, kLongestView);
  view.range_m = view.returns ? r : std::min<double>(r, beam.range);
  view.turn_rad = std::abs(scan.angle_increment);
  const auto first = log_.T_path_base.at(scan.stamp);
  const auto now = log_.T_path_base.at(scan.beam_stamp(i));
  const SE2 T_base_now = first->inverse() * *now;
  const Eigen::Isometry3d T_grid_laser =
      localization::to_se3(frame.T_map_grid.inverse() * aligned.T_map_base * T_base_now) *
      scan.T_base_laser;
  const double angle = scan.beam_angle(i);
  const Eigen::Vector3d d =
      T_grid_laser.linear() * Eigen::Vector3d(std::cos(angle), std::sin(angle), 0.0);
  const Eigen::Vector2d direction = d.head<2>().normalized();
  view.from = T_grid_laser.translation().head<2>() / frame.resolution;
  view.end = view.from + (view.range_m / frame.resolution) * direction;
  const auto width = static_cast<std::size_t>(frame.width);
  const std::size_t column = beam.cell % width;
  const std::size_t row = beam.cell / width;
  view.wall = Eigen::Vector2d(static_cast<double>(column) + 0.5, static_cast<double>(row) + 0.5);
  const double margin = std::max(kOffWall, 0.02 * r);
  view.foreign = view.returns && r < beam.range - margin &&
                 distances_.at(view.end * frame.resolution) > kOffWall;
  view.through = view.returns && beam.wall && r > beam.range + 2.0 * margin;
  view.confirms = view.returns && beam.wall && std::abs(r - beam.range) < margin;
  return view;
}

}  // namespace castaway::testbed
