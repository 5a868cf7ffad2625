#include "sim/stages/sensor_stage.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "sim/stages/sensor_streams.hpp"

namespace castaway::sim {
namespace {

using std::chrono::nanoseconds;

WheelAngles interpolate(const WheelAngles& a, const WheelAngles& b, double fraction) {
  return {a.left + fraction * (b.left - a.left), a.right + fraction * (b.right - a.right)};
}

Rng imu_stream(const SimulationStreams& streams) {
  if (!streams.named) {
    throw std::invalid_argument("imu: no random stream for it: give SimulationStreams::named");
  }
  return streams.named("imu");
}

double turn_of(const Motion& motion) {
  return wrap_angle(to_planar(motion.T_map_base_end).yaw - to_planar(motion.T_map_base_begin).yaw);
}

std::vector<LidarConfig> require_own_names(const std::vector<LidarConfig>& lidars) {
  if (lidars.empty()) throw std::invalid_argument("lidars: the list is empty: give at least one");
  for (auto lidar = lidars.begin(); lidar != lidars.end(); ++lidar) {
    const bool taken = std::any_of(
        lidars.begin(), lidar, [&](const LidarConfig& other) { return other.name == lidar->name; });
    if (taken) {
      throw std::invalid_argument("lidars: two are named '" + lidar->name +
                                  "': give each a unique name");
    }
  }
  return lidars;
}

}  // namespace

SensorStage::SensorStage(const SimulationConfig& config, const SimulationStreams& streams)
    : scene_(ray_primitives(config.world)),
      configs_(require_own_names(config.lidars)),
      timeline_(config.events.faults),
      odometry_(config, streams),
      odometry_period_(std::llround(1e9 / config.odometry.rate_hz)) {
  if (const auto& imu = config.sensors.imu) imu_.emplace(*imu, imu_stream(streams));
  const Surfaces surfaces(config.world);
  for (const LidarConfig& lidar : configs_) {
    devices_.push_back({LidarSweeper(lidar, surfaces, lidar_draws(streams, lidar)),
                        LidarFaults(config.events.faults, lidar, config.open)});
  }
}

void SensorStage::add(const FaultSpec& fault) {
  timeline_.add(fault);
  for (Device& device : devices_) device.faults.add(fault);
  odometry_.add(fault);
}

void SensorStage::set_world(const WorldSpec& world) {
  scene_ = RayScene(ray_primitives(world));
  const Surfaces surfaces(world);
  for (Device& device : devices_) device.sweeper.set_surfaces(surfaces);
}

void SensorStage::set_covered(bool covered) {
  for (Device& device : devices_) device.sweeper.set_covered(covered);
}

std::vector<FaultRecord> SensorStage::read_faults(const Motion& motion) {
  std::vector<FaultRecord> records = timeline_.take_due(motion.end - nanoseconds(1));
  for (FaultRecord& record : records) record.T_map_base_true = to_planar(motion.at(record.stamp));
  return records;
}

std::vector<OdometryReading> SensorStage::read_odometry(const Motion& motion,
                                                        const WheelAngles& begin,
                                                        const WheelAngles& end,
                                                        std::int64_t collisions) {
  std::vector<OdometryReading> readings;
  const double turn = turn_of(motion);
  for (; next_odometry_ < motion.end; next_odometry_ += odometry_period_) {
    const double fraction = motion.fraction(next_odometry_);
    const Eigen::Isometry3d T_map_base = motion.at(next_odometry_);
    const Pose2 planar = to_planar(T_map_base);
    auto reading = odometry_.read({next_odometry_, interpolate(begin, end, fraction),
                                   turned_ + fraction * turn, planar, collisions});
    if (!reading) continue;
    reading->T_footprint_base_true = to_isometry(planar).inverse() * T_map_base;
    readings.push_back(*reading);
  }
  turned_ += turn;
  return readings;
}

std::vector<SimFrame> SensorStage::read_further(const Motion& motion, bool moved) {
  std::vector<SimFrame> frames;
  if (!imu_) return frames;
  for (const ImuReading& reading : imu_->read(motion, moved)) {
    frames.push_back({reading.stamp, reading});
  }
  return frames;
}

std::vector<SimFrame> SensorStage::read_lidars(const Surroundings& around, const Motion& motion) {
  for (std::size_t i = 0; i < devices_.size(); ++i) {
    for (Sweep& sweep : devices_[i].sweeper.advance(around, motion)) {
      sweep.reading.lidar = i;
      auto passed = devices_[i].faults.deliver(std::move(sweep));
      if (passed) pending_.push_back(std::move(*passed));
    }
  }
  std::vector<SimFrame> due;
  if (pending_.empty()) return due;
  std::vector<Sweep> later;
  for (Sweep& sweep : pending_) {
    if (sweep.last_beam < motion.end) {
      due.push_back({sweep.last_beam, std::move(sweep.reading)});
    } else {
      later.push_back(std::move(sweep));
    }
  }
  pending_ = std::move(later);
  return due;
}

}  // namespace castaway::sim
