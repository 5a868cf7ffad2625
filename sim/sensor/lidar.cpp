#include "sim/sensor/lidar.hpp"

#include <cmath>
#include <limits>
#include <numbers>

namespace castaway::sim {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

/// Where a ray meets the floor, z = 0.
double distance_to_floor(const Ray& ray) {
  return ray.direction.z() < 0.0 ? std::max(-ray.origin.z() / ray.direction.z(), 0.0) : kNoHit;
}

std::chrono::nanoseconds to_nanoseconds(double seconds) {
  return std::chrono::nanoseconds(std::llround(seconds * 1e9));
}

}  // namespace

std::optional<RayHit> cast(const Surroundings& around, const Ray& ray, double max_distance,
                           std::uint32_t guess) {
  std::optional<RayHit> hit = around.fixed.cast(ray, max_distance, guess);
  if (around.moving == nullptr) return hit;
  std::optional<RayHit> nearer = around.moving->cast(ray, hit ? hit->distance : max_distance);
  if (!nearer) return hit;
  if (hit) nearer->primitive = hit->primitive;
  return nearer;
}

Lidar::Lidar(const LidarConfig& config) : config_(config) {
  validate(config);
  for (int i = 0; i < config.beams; ++i) {
    const double angle = config.angle_min + config.angle_increment * i;
    directions_.emplace_back(config.T_base_laser.linear() *
                             Eigen::Vector3d(std::cos(angle), std::sin(angle), 0.0));
  }
}

Ray Lidar::ray(const Eigen::Isometry3d& T_map_base, int index) const {
  return {T_map_base * config_.T_base_laser.translation(),
          T_map_base.linear() * directions_[static_cast<std::size_t>(index)]};
}

Beam Lidar::cast(const Surroundings& around, const Eigen::Isometry3d& T_map_base, int index,
                 Rng& rng, std::uint32_t guess) const {
  const Ray beam = ray(T_map_base, index);
  const double floor = distance_to_floor(beam);
  const double limit = std::min(config_.range_max, floor);
  const std::optional<RayHit> hit = sim::cast(around, beam, limit, guess);
  if (!hit && floor > config_.range_max) return {kInfinity, kHitNothing, guess};
  const double range = measured_range(config_.noise, hit ? hit->distance : floor, rng);
  const std::uint32_t primitive = hit ? hit->primitive : kNoPrimitive;
  if (range > config_.range_max) return {kInfinity, kHitNothing, primitive};
  const int object = hit ? hit->object : kHitFloor;
  if (range < config_.range_min) return {-kInfinity, object, primitive};
  return {static_cast<float>(range), object, primitive};
}

double Motion::fraction(std::chrono::nanoseconds stamp) const {
  return static_cast<double>((stamp - begin).count()) / static_cast<double>((end - begin).count());
}

Eigen::Isometry3d Motion::at(std::chrono::nanoseconds stamp) const {
  return interpolate(T_map_base_begin, T_map_base_end, fraction(stamp));
}

LidarSweeper::LidarSweeper(const LidarConfig& config)
    : lidar_(config), period_(to_nanoseconds(1.0 / config.rate_hz)) {
  if (!config.sweep) return;
  const double turn = std::abs(config.angle_increment) / (2.0 * std::numbers::pi);
  time_increment_ = std::chrono::nanoseconds(
      static_cast<std::int64_t>(static_cast<double>(period_.count()) * turn));
}

void LidarSweeper::begin_scan(const Motion& motion) {
  reading_ = {};
  reading_.stamp = scan_stamp_;
  reading_.time_increment = time_increment_;
  reading_.T_map_base_true = to_planar(motion.at(scan_stamp_));
  reading_.ranges.reserve(static_cast<std::size_t>(lidar_.config().beams));
  reading_.hit_object.reserve(static_cast<std::size_t>(lidar_.config().beams));
}

Beam LidarSweeper::next_beam(const Surroundings& around, const Eigen::Isometry3d& T_map_base,
                             Rng& rng) {
  if (covered_) return {kInfinity, kHitNothing, last_primitive_};
  return lidar_.cast(around, T_map_base, next_beam_, rng, last_primitive_);
}

std::vector<Sweep> LidarSweeper::advance(const Surroundings& around, const Motion& motion,
                                         Rng& rng) {
  std::vector<Sweep> done;
  if (scan_stamp_ + time_increment_ * next_beam_ >= motion.end) return done;
  const Interpolation path(motion.T_map_base_begin, motion.T_map_base_end);
  while (true) {
    const auto stamp = scan_stamp_ + time_increment_ * next_beam_;
    if (stamp >= motion.end) return done;
    if (next_beam_ == 0) begin_scan(motion);
    const Beam beam = next_beam(around, path.at(motion.fraction(stamp)), rng);
    last_primitive_ = beam.primitive;
    reading_.ranges.push_back(beam.range);
    reading_.hit_object.push_back(beam.object);
    if (++next_beam_ < lidar_.config().beams) continue;
    done.push_back({stamp, std::move(reading_)});
    next_beam_ = 0;
    scan_stamp_ += period_;
  }
}

}  // namespace castaway::sim
