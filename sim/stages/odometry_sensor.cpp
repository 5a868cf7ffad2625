#include "sim/stages/odometry_sensor.hpp"

#include "sim/common/seconds.hpp"
#include "sim/robot/robot_sensors.hpp"
#include "sim/stages/sensor_streams.hpp"

namespace castaway::sim {
namespace {

bool slips(const SimulationConfig& config) {
  const SlipConfig& slip = config.odometry.slip;
  const bool in_zones = slip.zones && !config.world.slip_zones.empty();
  return in_zones || slip.rate > 0.0 || slip.collision_length > 0.0;
}

}  // namespace

OdometrySensor::OdometrySensor(const SimulationConfig& config, const SimulationStreams& streams)
    : rng_(streams.odometry),
      faults_(config.events.faults),
      odometry_(config.odometry, drive_geometry(config.robot), rng_) {
  if (slips(config)) {
    slip_.emplace(config.odometry.slip, drive_geometry(config.robot), config.world.slip_zones,
                  named_stream(streams, "odometry/slip"));
  }
  if (config.odometry.gyro) {
    gyro_.emplace(*config.odometry.gyro, named_stream(streams, "odometry/gyro"));
  }
}

/// Slip and faults are kept as an offset, so that without them the angles are exactly the true
/// ones.
WheelAngles OdometrySensor::encoders(const DriveState& state) {
  const WheelAngles before = last_ ? last_->angles : WheelAngles{};
  const WheelAngles way{state.angles.left - before.left, state.angles.right - before.right};
  const WheelGain gain = faults_.gain(state.stamp);
  const WheelAngles slipped = slip_ ? slip_->count(way, state.T_map_base, state.collisions) : way;
  offset_.left += gain.left * slipped.left - way.left;
  offset_.right += gain.right * slipped.right - way.right;
  return {state.angles.left + offset_.left, state.angles.right + offset_.right};
}

std::optional<double> OdometrySensor::gyro_turn(const DriveState& state, bool frozen) {
  if (!gyro_) return std::nullopt;
  const double turn = last_ ? state.turned - last_->turned : state.turned;
  const auto since = last_ ? state.stamp - last_->stamp : std::chrono::nanoseconds(0);
  const double measured = gyro_->measure(turn, to_seconds(since));
  return frozen ? 0.0 : measured;
}

std::optional<OdometryReading> OdometrySensor::read(const DriveState& state) {
  const WheelAngles angles = encoders(state);
  const auto turn = gyro_turn(state, faults_.gain(state.stamp).frozen());
  odometry_.update(angles, rng_, turn);
  if (faults_.reset_due(state.stamp)) odometry_.reset();
  last_ = state;
  if (faults_.is_lost(state.stamp)) return std::nullopt;
  return OdometryReading{state.stamp, odometry_.T_odom_base(), state.T_map_base};
}

}  // namespace castaway::sim
