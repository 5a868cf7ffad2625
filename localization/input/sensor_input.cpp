#include "localization/input/sensor_input.hpp"

#include <algorithm>
#include <stdexcept>

#include "localization/input/layered_points.hpp"

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

void require_rate(double rate_hz, const char* name) {
  if (!(rate_hz > 0.0)) throw std::invalid_argument(std::string(name) + " must be positive");
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

void validate(const SensorInputConfig& config) {
  require_rate(config.predict_rate_hz, "predict_rate_hz");
  require_rate(config.correct_rate_hz, "correct_rate_hz");
  require_rate(config.reseed_rate_hz, "reseed_rate_hz");
  validate(config.beams);
}

SensorInput::SensorInput(const SensorInputConfig& config)
    : correct_rate_hz_(config.correct_rate_hz),
      beams_(config.beams),
      layers_(config.layers),
      intake_(config.intake),
      panorama_(config.lidar_memory),
      predict_rate_(config.predict_rate_hz, Stamp{}),
      correct_rate_(config.correct_rate_hz),
      reseed_rate_(config.reseed_rate_hz, Stamp{}) {}

OdometryTurn SensorInput::take(const Odometry& reading) {
  const Odometry odometry{reading.stamp, gyro_.take(reading.stamp, reading.T_odom_base)};
  const OdometryIntake taken = intake_.take(odometry);
  if (taken == OdometryIntake::kDropped) return {};
  OdometryTurn turn;
  turn.restarted = taken == OdometryIntake::kRestarted;
  if (turn.restarted) restart();
  if (!T_odom_particles_) T_odom_particles_ = odometry.T_odom_base;
  if (predict_rate_.take_turn(odometry.stamp)) turn.step = step_to(odometry.T_odom_base);
  return turn;
}

std::optional<ScanTurn> SensorInput::take(const LaserScan& scan) {
  if (!intake_.accept(scan)) return std::nullopt;
  ScanTurn turn;
  turn.now = intake_.T_odom_base().newest();
  turn.T_odom_base = *intake_.T_odom_base().at(turn.now);
  const auto seen = project(scan, turn.now);
  if (!seen) {
    intake_.drop_scan();
    return std::nullopt;
  }
  turn.points = panorama_.add(scan.lidar, *seen, turn.now, turn.T_odom_base);
  if (const auto up = gravity_.up()) turn.points.up = up->cast<float>();
  turn.step = step_to(turn.T_odom_base);
  turn.counts = !turn.points.empty() && correct_rate_.take_turn(turn.now);
  if (turn.counts) turn.periods = count(turn.now);
  turn.reseeds = turn.counts && reseed_rate_.take_turn(turn.now);
  return turn;
}

std::optional<ScanPoints> SensorInput::project(const LaserScan& scan, Stamp reference) const {
  const bool in_layers = layers_ && !scan.layers.empty();
  return in_layers ? project_layers(scan, intake_.T_odom_base(), reference, beams_)
                   : project_scan(scan, intake_.T_odom_base(), reference, beams_);
}

SE2 SensorInput::T_now_base(Stamp then) const {
  const std::optional<SE2> T_odom_then = intake_.T_odom_base().at(then);
  return T_odom_particles_->inverse() * T_odom_then.value_or(*T_odom_particles_);
}

void SensorInput::restart() {
  T_odom_particles_.reset();
  predict_rate_.restart();
  correct_rate_.restart();
  reseed_rate_.restart();
  counted_.reset();
  panorama_.clear();
  gravity_.clear();
  gyro_.clear();
}

/// Notes a scan that counts. Returns the periods since the last one.
double SensorInput::count(Stamp now) {
  const double periods = counted_ ? correct_rate_hz_ * seconds(now - *counted_) : 1.0;
  counted_ = now;
  return std::max(periods, 1.0);
}

/// Returns nothing if the robot has not moved.
std::optional<SE2> SensorInput::step_to(const SE2& T_odom_base) {
  const SE2 u = T_odom_particles_->inverse() * T_odom_base;
  if (u == SE2{}) return std::nullopt;
  T_odom_particles_ = T_odom_base;
  return u;
}

}  // namespace castaway::localization
