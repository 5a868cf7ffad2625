#include "robot.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "floor_plan.hpp"

using castaway::Pose2;

namespace {

constexpr double kTick = 0.02;  // [s]
constexpr int kTicksPerSweep = 5;
constexpr double kSpeed = 0.5;       // [m/s]
constexpr double kTurnRate = 0.8;    // [rad/s]
constexpr double kNear = 0.6;        // [m] A wall ahead: turn...
constexpr double kClear = 1.5;       // [m] ...until there is none.
constexpr double kWheelsErr = 1.02;  // The wheels are larger than their driver believes.
constexpr double kDegree = std::numbers::pi / 180.0;

}  // namespace

Robot::Robot(castaway::OccupancyGrid plan) : plan_(std::move(plan)) {}

Message Robot::next() {
  const bool sweeps = ticks_ % (kTicksPerSweep + 1) == kTicksPerSweep;
  ++ticks_;
  if (sweeps) return sweep();
  drive();
  const int driven = ticks_ - ticks_ / (kTicksPerSweep + 1);
  return WheelMessage{driven * kTick, T_odom_base_.x, T_odom_base_.y, T_odom_base_.yaw / kDegree};
}

double Robot::room_ahead() const {
  double room = kLidarRange;
  for (const double aside : {-0.5, -0.25, 0.0, 0.25, 0.5}) {
    room = std::min(room, distance_to_wall(plan_, T_map_base_.translation(),
                                           T_map_base_.yaw + aside, kLidarRange));
  }
  return room;
}

void Robot::drive() {
  turning_ = room_ahead() < (turning_ ? kClear : kNear);
  const Pose2 step =
      turning_ ? Pose2{0.0, 0.0, kTurnRate * kTick} : Pose2{kSpeed * kTick, 0.0, 0.0};
  T_map_base_ = T_map_base_ * step;
  T_odom_base_ = T_odom_base_ * Pose2{step.x / kWheelsErr, 0.0, step.yaw};
}

/// Taken at once, at the time of the last reading of the wheels.
SweepMessage Robot::sweep() const {
  const int driven = ticks_ - ticks_ / (kTicksPerSweep + 1);
  SweepMessage message{driven * kTick, {}};
  const Eigen::Vector2d p_map_lidar = T_map_base_ * Eigen::Vector2d(kLidarAhead, 0.0);
  for (int degree = -180; degree < 180; ++degree) {
    const double distance =
        distance_to_wall(plan_, p_map_lidar, T_map_base_.yaw + degree * kDegree, kLidarRange);
    message.distances_mm.push_back(
        distance < kLidarRange ? static_cast<int>(std::lround(1000.0 * distance)) : 0);
  }
  return message;
}
