#include "sim/sensor/lidar.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include <boost/random/normal_distribution.hpp>

#include "sim/common/seconds.hpp"

namespace castaway::sim {
namespace {

constexpr float kInfiniteRange = std::numeric_limits<float>::infinity();

}  // namespace

Lidar::Lidar(const LidarConfig& config, Surfaces surfaces, Rng pattern) : config_(config) {
  validate(config);
  if (any(config.light) || config.intensity != Intensity::kNone) {
    light_.emplace(config.light, std::move(surfaces), config.range_max);
  }
  const Eigen::Matrix3d R_base_laser = config.T_base_laser.linear();
  boost::random::normal_distribution<double> offset(0.0, config.noise.beam_bias_sigma);
  const std::size_t beams = static_cast<std::size_t>(config.beams) * config.elevations.size();
  for (std::size_t i = 0; i < beams; ++i) {
    directions_.emplace_back(R_base_laser * beam_direction(config, i));
    if (config.noise.beam_bias_sigma > 0.0) offsets_.push_back(offset(pattern));
  }
}

Ray Lidar::ray(const Eigen::Isometry3d& T_map_base, int index) const {
  return {T_map_base * config_.T_base_laser.translation(),
          T_map_base.linear() * directions_[static_cast<std::size_t>(index)]};
}

Eigen::Vector3d Lidar::across(const Eigen::Isometry3d& T_map_base, const Ray& beam) const {
  const Eigen::Vector3d up = T_map_base.linear() * config_.T_base_laser.linear().col(2);
  return up.cross(beam.direction).normalized();
}

float Lidar::intensity(const Echo& echo) const {
  const double reflected = echo.reflectivity * echo.cosine;
  if (config_.intensity == Intensity::kReflectivity) return static_cast<float>(reflected);
  if (config_.intensity == Intensity::kNone || echo.object == kHitNothing) return 0.0F;
  const double range = std::max(echo.range, config_.range_min);
  return static_cast<float>(reflected / std::max(range * range, 1e-6));
}

/// Where a beam hits something, noise is drawn even if the light is lost, so that light effects do
/// not shift the draws of noise.
Beam Lidar::report(const Echo& echo, int index, Rng& rng) const {
  if (!echo.met && echo.object == kHitNothing) return {kInfiniteRange, kHitNothing, echo.primitive};
  double range = echo.range;
  if (echo.met) {
    const double offset = offsets_.empty() ? 0.0 : offsets_[static_cast<std::size_t>(index)];
    const double true_range = std::min(echo.range, config_.range_max);
    range = measure_range(config_.noise, true_range, offset, rng);
  }
  if (echo.object == kHitNothing || range > config_.range_max) {
    return {kInfiniteRange, kHitNothing, echo.primitive};
  }
  if (range < config_.range_min) return {-kInfiniteRange, echo.object, echo.primitive};
  return {static_cast<float>(range), echo.object, echo.primitive, intensity(echo)};
}

Beam Lidar::cast(const Surroundings& around, const Eigen::Isometry3d& T_map_base, int index,
                 LidarDraws& draws, std::uint32_t guess) const {
  const Ray beam = ray(T_map_base, index);
  if (!light_) {
    return report(first_echo(around, beam, config_.range_max, guess), index, draws.noise);
  }
  const Echo echo = light_->echo(around, beam, across(T_map_base, beam), draws, guess);
  return report(echo, index, draws.noise);
}

double Motion::fraction(std::chrono::nanoseconds stamp) const {
  return static_cast<double>((stamp - begin).count()) / static_cast<double>((end - begin).count());
}

Eigen::Isometry3d Motion::at(std::chrono::nanoseconds stamp) const {
  return interpolate(T_map_base_begin, T_map_base_end, fraction(stamp));
}

LidarSweeper::LidarSweeper(const LidarConfig& config, const Surfaces& surfaces,
                           const LidarDraws& draws)
    : lidar_(config, surfaces, draws.pattern),
      draws_(draws),
      period_(to_nanoseconds(1.0 / config.rate_hz)),
      last_primitives_(config.elevations.size(), kNoPrimitive) {
  if (!config.scan_times.empty()) scan_stamp_ = config.scan_times.front();
  if (!config.sweep) return;
  const double turn = std::abs(config.angle_increment) / (2.0 * std::numbers::pi);
  time_increment_ = std::chrono::nanoseconds(
      static_cast<std::int64_t>(static_cast<double>(period_.count()) * turn));
}

void LidarSweeper::begin_scan(const Motion& motion) {
  const LidarConfig& config = lidar_.config();
  const std::size_t layers = config.elevations.size();
  const std::size_t beams = static_cast<std::size_t>(config.beams) * layers;
  reading_ = {};
  reading_.stamp = scan_stamp_;
  reading_.time_increment = time_increment_;
  reading_.layers = static_cast<int>(layers);
  const Eigen::Isometry3d T_map_base = motion.at(scan_stamp_);
  reading_.T_map_base_true = to_planar(T_map_base);
  reading_.T_footprint_base_true = to_isometry(reading_.T_map_base_true).inverse() * T_map_base;
  reading_.ranges.assign(beams, kInfiniteRange);
  reading_.hit_object.assign(beams, kHitNothing);
  if (config.intensity != Intensity::kNone) reading_.intensities.assign(beams, 0.0F);
}

/// Casts the beams of all layers at one angle.
void LidarSweeper::cast_column(const Surroundings& around, const Eigen::Isometry3d& T_map_base) {
  for (std::size_t layer = 0; layer < last_primitives_.size(); ++layer) {
    const int index = static_cast<int>(layer) * lidar_.config().beams + next_beam_;
    const auto at = static_cast<std::size_t>(index);
    const Beam beam = lidar_.cast(around, T_map_base, index, draws_, last_primitives_[layer]);
    last_primitives_[layer] = beam.primitive;
    reading_.ranges[at] = beam.range;
    reading_.hit_object[at] = beam.object;
    if (!reading_.intensities.empty()) reading_.intensities[at] = beam.intensity;
  }
}

/// Adds the error of the stamp. Stamps neither go back nor before the start of the run.
void LidarSweeper::misstate_stamp() {
  const double sigma = lidar_.config().stamp_sigma;
  if (sigma > 0.0) {
    reading_.stamp = std::max(reading_.stamp + to_nanoseconds(sigma * draw_normal(draws_.stamps)),
                              stated_stamp_ + std::chrono::nanoseconds(1));
  }
  stated_stamp_ = reading_.stamp;
}

/// Sets the time of the next scan; `end` is that of the last beam before.
void LidarSweeper::end_scan(std::chrono::nanoseconds end) {
  const auto& times = lidar_.config().scan_times;
  next_beam_ = 0;
  ++scans_;
  if (times.empty()) {
    scan_stamp_ += period_;
  } else if (scans_ < times.size()) {
    scan_stamp_ = std::max(times[scans_], end + std::chrono::nanoseconds(1));
  } else {
    scan_stamp_ = std::chrono::nanoseconds::max() / 2;
  }
}

std::vector<Sweep> LidarSweeper::advance(const Surroundings& around, const Motion& motion) {
  std::vector<Sweep> done;
  if (scan_stamp_ + time_increment_ * next_beam_ >= motion.end) return done;
  const Interpolation path(motion.T_map_base_begin, motion.T_map_base_end);
  while (true) {
    const auto stamp = scan_stamp_ + time_increment_ * next_beam_;
    if (stamp >= motion.end) return done;
    if (next_beam_ == 0) begin_scan(motion);
    if (!covered_) cast_column(around, path.at(motion.fraction(stamp)));
    if (++next_beam_ < lidar_.config().beams) continue;
    misstate_stamp();
    done.push_back({stamp, std::move(reading_)});
    end_scan(stamp);
  }
}

}  // namespace castaway::sim
