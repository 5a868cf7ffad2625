#include "tools/play/replay/spliced_kidnap.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace castaway::testbed {
namespace {

const OdometryFrame& odometry_at(const Frames& frames, std::size_t position) {
  return std::get<OdometryFrame>(frames[position].data);
}

const LaserScan& scan_after(const Frames& frames, std::size_t position) {
  while (!std::holds_alternative<ScanFrame>(frames[position].data)) ++position;
  return std::get<ScanFrame>(frames[position].data).scan;
}

/// The scan half a log away, so that a kidnap leads far, but early enough to track for `lead`
/// scans.
std::size_t first_half_a_log_away(std::size_t to, std::size_t scans, std::size_t lead) {
  const std::size_t half = to < scans / 2 ? to + scans / 2 : to - scans / 2;
  return std::min(half, scans > lead ? scans - lead - 1 : 0);
}

/// Difference in height. [m] 0 where it is unknown.
double rise(const OdometryFrame& a, const OdometryFrame& b) {
  const auto z_a = height_of(a);
  const auto z_b = height_of(b);
  return z_a && z_b ? std::abs(*z_a - *z_b) : 0.0;
}

/// Between two true poses, with their heights. [m]
double true_distance(const OdometryFrame& a, const OdometryFrame& b) {
  return std::hypot(distance(a.true_pose->T_map_base, b.true_pose->T_map_base), rise(a, b));
}

/// Cost of a kidnap from one scan to another: the least is chosen.
double cost(const Frames& frames, std::size_t from, std::size_t to, const SpliceConfig& config) {
  if (config.kind == SpliceKind::kLookAlike) {
    return range_difference(scan_after(frames, from), scan_after(frames, to), config.range_max);
  }
  return true_distance(odometry_at(frames, from), odometry_at(frames, to));
}

/// False if a true pose is unknown.
bool is_elsewhere(const OdometryFrame& a, const OdometryFrame& b, const SpliceConfig& config) {
  if (!a.true_pose || !b.true_pose) return false;
  return true_distance(a, b) >= config.min_distance_m ||
         yaw_distance(a.true_pose->T_map_base, b.true_pose->T_map_base) >= config.min_turn_rad;
}

}  // namespace

SpliceKind parse_splice_kind(const std::string& text) {
  for (std::size_t i = 0; i < std::size(kSpliceKinds); ++i) {
    if (text == kSpliceKinds[i]) return static_cast<SpliceKind>(i);
  }
  throw std::invalid_argument("no kind of splice '" + text + "'; there are far, near, look-alike");
}

double range_difference(const LaserScan& a, const LaserScan& b, double range_max) {
  constexpr std::size_t kBeams = 90;
  if (a.ranges.size() != b.ranges.size() || a.ranges.empty()) return 1.0;
  const auto returned = [&](float range) {
    return std::isfinite(range) && (range_max <= 0.0 || static_cast<double>(range) <= range_max);
  };
  const std::size_t step = std::max<std::size_t>(1, a.ranges.size() / kBeams);
  double sum = 0.0;
  std::size_t beams = 0;
  for (std::size_t i = 0; i < a.ranges.size(); i += step, ++beams) {
    const bool both = returned(a.ranges[i]) && returned(b.ranges[i]);
    if (both) {
      sum += std::min(1.0, std::abs(static_cast<double>(a.ranges[i] - b.ranges[i])));
    } else if (returned(a.ranges[i]) != returned(b.ranges[i])) {
      sum += 1.0;
    }
  }
  return sum / static_cast<double>(beams);
}

Splice choose_splice(const Frames& frames, std::size_t to, const SpliceConfig& config) {
  const std::vector<std::size_t> positions = scan_positions(frames);
  const std::size_t scans = positions.size();
  Splice at;
  at.to = to;
  if (config.kind == SpliceKind::kFar) {
    at.from_first = first_half_a_log_away(to, scans, config.lead);
    at.from = std::min(at.from_first + config.lead, scans - 1);
    return at;
  }
  const std::size_t target = positions.at(to);
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = std::min(config.lead, scans - 1); i < scans; ++i) {
    if (!is_elsewhere(odometry_at(frames, positions[i]), odometry_at(frames, target), config)) {
      continue;
    }
    const double c = cost(frames, positions[i], target, config);
    if (c >= least) continue;
    least = c;
    at.from = i;
  }
  if (!std::isfinite(least)) {
    throw std::runtime_error("the log has no other place with a true pose to kidnap from");
  }
  at.from_first = at.from - std::min(at.from, config.lead);
  return at;
}

}  // namespace castaway::testbed
