#include "localization/sensor/scan_points.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace castaway::localization {
namespace {

std::vector<std::size_t> valid_beams(const LaserScan& scan, const BeamSelection& selection) {
  std::vector<std::size_t> valid;
  for (std::size_t i = 0; i < scan.ranges.size(); ++i) {
    if (is_valid_range(scan, selection, scan.ranges[i])) valid.push_back(i);
  }
  return valid;
}

void copy_point(const ScanPoints& from, std::size_t i, ScanPoints& to) {
  to.x.push_back(from.x[i]);
  to.y.push_back(from.y[i]);
  to.z.push_back(from.z[i]);
  to.origin_x.push_back(from.origin_x[i]);
  to.origin_y.push_back(from.origin_y[i]);
  to.origin_z.push_back(from.origin_z[i]);
  to.range.push_back(from.range[i]);
  if (!from.kinds.empty()) to.kinds.push_back(from.kinds[i]);
}

}  // namespace

void validate(const BeamSelection& selection) {
  if (selection.max_beams < 1) throw std::invalid_argument("max_beams must be at least 1");
  if (!(selection.max_range > 0.0)) throw std::invalid_argument("max_range must be positive");
  if (selection.max_tilted < 0) throw std::invalid_argument("max_tilted must not be negative");
  if (selection.max_flat < 0) throw std::invalid_argument("max_flat must not be negative");
}

bool is_valid_range(const LaserScan& scan, const BeamSelection& selection, double range) {
  return std::isfinite(range) && range >= scan.range_min && range > 0.0 &&
         range <= std::min(scan.range_max, selection.max_range);
}

void append_beam(ScanPoints& points, const Eigen::Isometry3d& T_base_laser,
                 const Eigen::Vector3d& end) {
  const Eigen::Vector3d p = T_base_laser * end;
  const Eigen::Vector3d origin = T_base_laser.translation();
  points.x.push_back(static_cast<float>(p.x()));
  points.y.push_back(static_cast<float>(p.y()));
  points.z.push_back(static_cast<float>(p.z()));
  points.origin_x.push_back(static_cast<float>(origin.x()));
  points.origin_y.push_back(static_cast<float>(origin.y()));
  points.origin_z.push_back(static_cast<float>(origin.z()));
  points.range.push_back(static_cast<float>((p - origin).head<2>().norm()));
}

std::optional<ScanPoints> project_scan(const LaserScan& scan, const TransformBuffer& T_odom_base,
                                       Stamp reference, const BeamSelection& selection) {
  const std::optional<SE2> T_odom_reference = T_odom_base.at(reference);
  const std::optional<SE2> T_odom_first = T_odom_base.at(scan.stamp);
  if (!T_odom_reference || !T_odom_first) return std::nullopt;
  const SE2 T_reference_odom = T_odom_reference->inverse();
  Eigen::Isometry3d T_reference_laser =
      to_se3(T_reference_odom * *T_odom_first) * scan.T_base_laser;
  const std::vector<std::size_t> valid = valid_beams(scan, selection);
  ScanPoints points;
  if (!scan.ranges.empty()) {
    points.valid_share =
        static_cast<double>(valid.size()) / static_cast<double>(scan.ranges.size());
  }
  for (const std::size_t k : even_indices(valid.size(), selection.max_beams)) {
    const std::size_t i = valid[k];
    if (scan.time_increment != Stamp::zero()) {
      const std::optional<SE2> T_odom_beam = T_odom_base.at(scan.beam_stamp(i));
      if (!T_odom_beam) return std::nullopt;
      T_reference_laser = to_se3(T_reference_odom * *T_odom_beam) * scan.T_base_laser;
    }
    const double angle = scan.beam_angle(i);
    const double range = scan.ranges[i];
    append_beam(points, T_reference_laser, {range * std::cos(angle), range * std::sin(angle), 0.0});
  }
  return points;
}

std::vector<std::size_t> even_indices(std::size_t size, int count) {
  const std::size_t used = std::min(size, static_cast<std::size_t>(count));
  std::vector<std::size_t> indices(used);
  for (std::size_t k = 0; k < used; ++k) indices[k] = k * size / used;
  return indices;
}

ScanPoints points_at(const ScanPoints& points, const std::vector<std::size_t>& indices) {
  ScanPoints some;
  some.valid_share = points.valid_share;
  some.up = points.up;
  for (const std::size_t i : indices) copy_point(points, i, some);
  return some;
}

ScanPoints thin(const ScanPoints& points, int count) {
  if (points.size() <= static_cast<std::size_t>(count)) return points;
  return points_at(points, even_indices(points.size(), count));
}

ScanPoints farthest_points(const ScanPoints& points, double share) {
  if (points.empty()) return points;
  std::vector<float> ranges = points.range;
  const auto skipped =
      static_cast<std::size_t>((1.0 - share) * static_cast<double>(ranges.size() - 1));
  const auto nth = ranges.begin() + static_cast<std::ptrdiff_t>(skipped);
  std::nth_element(ranges.begin(), nth, ranges.end());
  const float least = *nth;
  ScanPoints far;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (points.range[i] < least) continue;
    copy_point(points, i, far);
  }
  return far;
}

}  // namespace castaway::localization
