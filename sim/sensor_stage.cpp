#include "sim/sensor_stage.hpp"

#include <cmath>
#include <utility>

namespace castaway::sim {
namespace {

using std::chrono::nanoseconds;

WheelAngles interpolate(const WheelAngles& a, const WheelAngles& b, double fraction) {
  return {a.left + fraction * (b.left - a.left), a.right + fraction * (b.right - a.right)};
}

}  // namespace

SensorStage::SensorStage(const SimulationConfig& config, const SimulationStreams& streams)
    : scene_(ray_primitives(config.world)),
      lidar_rng_(streams.lidar),
      odometry_rng_(streams.odometry),
      lidar_(config.lidar),
      odometry_(config.odometry, drive_geometry(config.robot), odometry_rng_),
      odometry_period_(std::llround(1e9 / config.odometry.rate_hz)) {}

std::vector<SimFrame> SensorStage::read_odometry(const Motion& motion, const WheelAngles& begin,
                                                 const WheelAngles& end) {
  std::vector<SimFrame> frames;
  for (; next_odometry_ < motion.end; next_odometry_ += odometry_period_) {
    odometry_.update(interpolate(begin, end, motion.fraction(next_odometry_)), odometry_rng_);
    frames.push_back({next_odometry_, OdometryReading{next_odometry_, odometry_.T_odom_base(),
                                                      to_planar(motion.at(next_odometry_))}});
  }
  return frames;
}

std::vector<SimFrame> SensorStage::read_lidar(const Surroundings& around, const Motion& motion) {
  std::vector<SimFrame> frames;
  for (Sweep& sweep : lidar_.advance(around, motion, lidar_rng_)) {
    frames.push_back({sweep.last_beam, std::move(sweep.reading)});
  }
  return frames;
}

}  // namespace castaway::sim
