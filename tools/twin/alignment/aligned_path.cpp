#include "tools/twin/alignment/aligned_path.hpp"

#include <algorithm>

namespace castaway::testbed {
namespace {

constexpr Stamp kLongestGap = std::chrono::milliseconds(100);

/// Adds poses between two scans. Odometry gives the shape of the motion, and what it misses is
/// added in proportion to time.
void add_between(const AlignedLog& log, const AlignedScan& from, const AlignedScan& to,
                 std::vector<PathPose>& path) {
  const auto T_path_from = log.T_path_base.at(from.scan.stamp);
  const auto T_path_to = log.T_path_base.at(to.scan.stamp);
  if (!T_path_from || !T_path_to || to.breaks) return;
  const SE2 T_from_to = T_path_from->inverse() * *T_path_to;
  const SE2 T_to_miss = T_from_to.inverse() * from.T_map_base.inverse() * to.T_map_base;
  const Stamp gap = to.scan.stamp - from.scan.stamp;
  const std::int64_t parts = (gap + kLongestGap - Stamp(1)) / kLongestGap;
  for (std::int64_t k = 1; k < parts; ++k) {
    const Stamp stamp = from.scan.stamp + gap * k / parts;
    const SE2 T_from_now = T_path_from->inverse() * *log.T_path_base.at(stamp);
    const double part = static_cast<double>(k) / static_cast<double>(parts);
    path.push_back(
        {stamp, from.T_map_base * T_from_now * localization::interpolate({}, T_to_miss, part)});
  }
}

}  // namespace

std::vector<PathPose> path_of(const AlignedLog& log) {
  std::vector<PathPose> path;
  const AlignedScan* before = nullptr;
  for (const AlignedScan& scan : log.scans) {
    if (before != nullptr && scan.scan.stamp <= before->scan.stamp) continue;
    if (before != nullptr) add_between(log, *before, scan, path);
    path.push_back({scan.scan.stamp, scan.T_map_base});
    before = &scan;
  }
  return path;
}

std::vector<Stamp> played_times(const AlignedLog& log) {
  const Stamp first = log.scans.front().scan.stamp;
  const Stamp last = log.scans.back().scan.stamp;
  std::vector<Stamp> times;
  for (const Stamp stamp : log.stamps) {
    if (first <= stamp && stamp <= last) times.push_back(stamp - first);
  }
  std::sort(times.begin(), times.end());
  return times;
}

}  // namespace castaway::testbed
