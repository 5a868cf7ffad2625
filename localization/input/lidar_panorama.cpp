#include "localization/input/lidar_panorama.hpp"

namespace castaway::localization {
namespace {

/// Appends the kinds of the points that were appended last.
void append_kinds(const ScanPoints& points, ScanPoints& all) {
  if (points.kinds.empty() && all.kinds.empty()) return;
  all.kinds.resize(all.size() - points.size(), BeamKind::kLevel);
  for (std::size_t i = 0; i < points.size(); ++i) all.kinds.push_back(points.kind(i));
}

/// Appends points that are given in an earlier frame of base; `T_now_then` is that frame in the
/// current one.
void append(const ScanPoints& points, const SE2& T_now_then, ScanPoints& all) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Eigen::Vector2d end = T_now_then * Eigen::Vector2d(points.x[i], points.y[i]);
    const Eigen::Vector2d origin =
        T_now_then * Eigen::Vector2d(points.origin_x[i], points.origin_y[i]);
    all.x.push_back(static_cast<float>(end.x()));
    all.y.push_back(static_cast<float>(end.y()));
    all.z.push_back(points.z[i]);
    all.origin_x.push_back(static_cast<float>(origin.x()));
    all.origin_y.push_back(static_cast<float>(origin.y()));
    all.origin_z.push_back(points.origin_z[i]);
    all.range.push_back(points.range[i]);
  }
  append_kinds(points, all);
}

}  // namespace

ScanPoints LidarPanorama::add(const std::string& lidar, const ScanPoints& points, Stamp now,
                              const SE2& T_odom_base) {
  newest_[lidar] = {now, T_odom_base, points};
  ScanPoints all = points;
  for (const auto& [name, entry] : newest_) {
    if (name == lidar || now - entry.stamp > memory_) continue;
    append(entry.points, T_odom_base.inverse() * entry.T_odom_base, all);
  }
  return all;
}

}  // namespace castaway::localization
