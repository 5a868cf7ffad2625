#include "tools/ros/clouds/ring_cloud.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <optional>
#include <stdexcept>

#include "localization/geometry/se2.hpp"
#include "tools/ros/clouds/cloud_field.hpp"

namespace castaway::testbed {
namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;
constexpr double kNearest = 0.1;         // [m] Zeros are points without a return.
constexpr double kFarthest = 1000.0;     // [m]
constexpr double kSameAzimuth = 1e-4;    // [rad] Several returns of one beam.
constexpr double kLongestSweep = 1.0;    // [s]
constexpr double kAbsolute = 1e6;        // [s] Larger times are not from the stamp.
constexpr double kLeastProgress = 0.05;  // [rad] By which the rotation is known.
constexpr std::size_t kMostRings = 1024;
constexpr double kLargestRing = 65535.0;
constexpr double kMostColumns = 3600.0;
constexpr double kFewestColumns = 36.0;
constexpr double kBefore = 2.0;  // [columns] Lasers that point ahead of the first one.

/// A return in the lidar's frame.
struct RingReturn {
  double azimuth = 0.0;    ///< [rad]
  double elevation = 0.0;  ///< [rad]
  double range = 0.0;      ///< [m]
  double time = 0.0;       ///< [s] From the stamp.
};

/// Returns of each ring, in the order of the cloud.
using Rings = std::map<int, std::vector<RingReturn>>;

/// How a lidar turns.
struct Rotation {
  double begin = 0.0;  ///< [rad] Azimuth of the first beam.
  double step = 0.0;   ///< [rad] Signed.
  double time = 0.0;   ///< [s] Of the first beam, from the stamp.
  double pace = 0.0;   ///< [s] Between two beams; 0: all at once.
};

/// Times of points. [s]
class CloudTimes {
 public:
  CloudTimes(const ros::PointCloud2& cloud, Stamp stamp)
      : field_(field_of(cloud, {"time", "t", "timestamp", "offset_time"})),
        stamp_(seconds(stamp)) {}
  [[nodiscard]] bool known() const { return field_.has_value(); }
  [[nodiscard]] double at(std::size_t point) const {
    if (!field_) return 0.0;
    const double value = field_->at(point);
    if (field_->type().kind != ScalarKind::kFloat) return 1e-9 * value;
    return std::abs(value) > kAbsolute ? value - stamp_ : value;
  }

 private:
  std::optional<CloudField> field_;
  double stamp_;
};

Rings rings_of(const ros::PointCloud2& cloud, const CloudTimes& times) {
  const CloudField x = require_field(cloud, "x");
  const CloudField y = require_field(cloud, "y");
  const CloudField z = require_field(cloud, "z");
  const auto ring =
      cloud.height > 1 ? field_of(cloud, {"ring"}) : std::optional(require_field(cloud, "ring"));
  Rings rings;
  for (std::size_t i = 0; i < std::size_t{cloud.width} * cloud.height; ++i) {
    const Eigen::Vector3d p(x.at(i), y.at(i), z.at(i));
    const double range = p.norm();
    const double time = times.at(i);
    if (!(range >= kNearest && range <= kFarthest) || !std::isfinite(time)) continue;
    const double flat = p.head<2>().norm();
    const std::size_t row = i / cloud.width;
    const double id = ring ? ring->at(i) : static_cast<double>(row);
    if (!(id >= 0.0 && id <= kLargestRing)) continue;
    rings[static_cast<int>(id)].push_back(
        {std::atan2(p.y(), p.x()), std::atan2(p.z(), flat), range, time});
  }
  if (rings.size() > kMostRings) {
    throw std::runtime_error(
        "a PointCloud2 has more than 1024 rings: it is not that of a spinning "
        "lidar; name another topic by --points-topic");
  }
  return rings;
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

const std::vector<RingReturn>& fullest(const Rings& rings) {
  return std::ranges::max_element(rings, {}, [](const auto& ring) { return ring.second.size(); })
      ->second;
}

/// Beams of a whole turn.
double columns_of(const std::vector<RingReturn>& ring) {
  std::vector<double> azimuths;
  for (const RingReturn& one : ring) azimuths.push_back(one.azimuth);
  std::ranges::sort(azimuths);
  std::vector<double> gaps;
  for (std::size_t i = 1; i < azimuths.size(); ++i) {
    const double gap = azimuths[i] - azimuths[i - 1];
    if (gap > kSameAzimuth) gaps.push_back(gap);
  }
  if (gaps.empty()) return kFewestColumns;
  return std::clamp(std::round(kTurn / median(std::move(gaps))), kFewestColumns, kMostColumns);
}

/// Direction and speed, by the times of one ring; nothing if they do not tell.
std::optional<Rotation> rotation_by_times(std::vector<RingReturn> ring, double step) {
  std::ranges::stable_sort(ring, {}, &RingReturn::time);
  double progress = 0.0;
  for (std::size_t i = 1; i < ring.size(); ++i) {
    progress += localization::wrap_angle(ring[i].azimuth - ring[i - 1].azimuth);
  }
  const double span = ring.back().time - ring.front().time;
  if (!(span > 0.0 && span <= kLongestSweep) || std::abs(progress) < kLeastProgress) {
    return std::nullopt;
  }
  Rotation rotation;
  rotation.step = std::copysign(step, progress);
  rotation.pace = span * step / std::abs(progress);
  rotation.begin = ring.front().azimuth - kBefore * rotation.step;
  const bool near = std::abs(ring.front().time) <= kLongestSweep;  // Else of another clock.
  rotation.time = (near ? ring.front().time : 0.0) - kBefore * rotation.pace;
  return rotation;
}

localization::ScanLayer layer_of(const std::vector<RingReturn>& ring, const Rotation& rotation,
                                 std::size_t columns) {
  localization::ScanLayer layer;
  std::vector<double> elevations;
  for (const RingReturn& one : ring) elevations.push_back(one.elevation);
  layer.elevation = median(std::move(elevations));
  layer.ranges.assign(columns, std::numeric_limits<float>::infinity());
  for (const RingReturn& one : ring) {
    const double turned = (one.azimuth - rotation.begin) / rotation.step;  // [columns]
    const auto whole = static_cast<std::int64_t>(std::llround(turned));
    const auto count = static_cast<std::int64_t>(columns);
    float& range = layer.ranges[static_cast<std::size_t>(((whole % count) + count) % count)];
    if (!std::isfinite(range)) range = static_cast<float>(one.range);
  }
  return layer;
}

void cut_level_layer(LaserScan& scan) {
  const auto level = std::ranges::min_element(
      scan.layers, {}, [](const auto& layer) { return std::abs(layer.elevation); });
  scan.ranges = level->ranges;
  for (float& range : scan.ranges) range *= static_cast<float>(std::cos(level->elevation));
}

}  // namespace

LaserScan scan_of_cloud(const ros::PointCloud2& cloud, Stamp stamp) {
  validate(cloud);
  const CloudTimes times(cloud, stamp);
  const Rings rings = rings_of(cloud, times);
  LaserScan scan;
  scan.stamp = stamp;
  scan.range_min = kNearest;
  scan.range_max = kFarthest;
  if (rings.empty()) return scan;
  const double columns = columns_of(fullest(rings));
  const double step = kTurn / columns;
  const Rotation at_once{-std::numbers::pi, step, 0.0, 0.0};
  const auto timed = times.known() ? rotation_by_times(fullest(rings), step) : std::nullopt;
  const Rotation rotation = timed.value_or(at_once);
  scan.stamp += localization::from_seconds(rotation.time);
  scan.time_increment = localization::from_seconds(rotation.pace);
  scan.angle_min = rotation.begin;
  scan.angle_increment = rotation.step;
  for (const auto& [id, ring] : rings) {
    scan.layers.push_back(layer_of(ring, rotation, static_cast<std::size_t>(columns)));
  }
  cut_level_layer(scan);
  return scan;
}

}  // namespace castaway::testbed
