#include "localization/sensor/beam_scan.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace castaway::localization {
namespace {

LaserScan every_nth(const LaserScan& scan, int max_beams) {
  LaserScan thin = scan;
  const auto count = static_cast<int>(scan.ranges.size());
  const int step = std::max(1, (count - 1) / std::max(1, max_beams - 1));
  thin.ranges.clear();
  for (int i = 0; i < count; i += step) {
    thin.ranges.push_back(scan.ranges[static_cast<std::size_t>(i)]);
  }
  thin.angle_increment = scan.angle_increment * step;
  thin.time_increment = Stamp::zero();
  return thin;
}

/// The scan with beams without a return ending at `longest` [m], and all others invalid.
LaserScan only_misses(LaserScan scan, double longest) {
  const auto end = std::nextafter(static_cast<float>(longest), 0.0F);
  for (float& range : scan.ranges) {
    const bool miss = std::isinf(range) && range > 0.0F;
    range = miss ? end : std::numeric_limits<float>::quiet_NaN();
  }
  return scan;
}

}  // namespace

std::optional<BeamScan> take_beams(const LaserScan& scan, const TransformBuffer& T_odom_base,
                                   int max_beams, double max_range) {
  const LaserScan thin = every_nth(scan, max_beams);
  const BeamSelection all{static_cast<int>(thin.ranges.size()) + 1, max_range};
  const double longest = std::min(scan.range_max, max_range);
  auto returns = project_scan(thin, T_odom_base, scan.stamp, all);
  auto misses = project_scan(only_misses(thin, longest), T_odom_base, scan.stamp, all);
  if (!returns || !misses) return std::nullopt;
  return BeamScan{std::move(*returns), std::move(*misses)};
}

}  // namespace castaway::localization
