/// A robot that is lifted, carried and put down.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "sim/common/geometry.hpp"

namespace castaway::sim {

/// What the wheels do in the air.
enum class HeldWheels : std::uint8_t {
  kDriven,  ///< Turn as commanded: the robot does not notice.
  kFree,    ///< Coast to a stop within half a second or so.
  kLocked,  ///< Stand still at once.
};

/// Velocity, as if on the floor, at which the wheels of a held robot turn `dt` [s] after they
/// turned at `now`; `commanded` is the drive's command.
Twist2 held_twist(HeldWheels wheels, const Twist2& now, const Twist2& commanded, double dt);

/// Parameters of a lift.
struct LiftConfig {
  double height = 0.6;   ///< [m] Of the wheels above the floor.
  double seconds = 4.0;  ///< [s] Least time from pick-up to put-down.
  double speed = 1.2;    ///< [m/s] Of the person who carries it.
  HeldWheels wheels = HeldWheels::kDriven;
  bool covered = false;  ///< The lidars see nothing while it is held.
};

/// @throws std::invalid_argument naming the field and the remedy.
void validate(const LiftConfig& config);

/// The way of a lifted robot.
struct LiftWay {
  Pose2 T_map_from;                     ///< Pose of base before.
  Pose2 T_map_to;                       ///< Pose of base after.
  std::vector<Eigen::Vector3d> path{};  ///< [m] Points of the ground in map, between the two.
  double z_from = 0.0;                  ///< [m] Height of the ground before.
  double z_to = 0.0;                    ///< [m] Height of the ground after.
};

/// The motion of a lifted robot: up, along a path while its heading turns evenly, down.
class Lift {
 public:
  Lift(const LiftConfig& config, const LiftWay& way);

  /// [s] From pick-up to put-down.
  [[nodiscard]] double duration() const { return duration_; }
  /// Pose of base `t` [s] after pick-up.
  [[nodiscard]] Eigen::Isometry3d at(double t) const;
  [[nodiscard]] const Pose2& T_map_to() const { return T_map_to_; }

 private:
  [[nodiscard]] Eigen::Vector3d along(double way) const;

  LiftConfig config_;
  Pose2 T_map_from_;
  Pose2 T_map_to_;
  std::vector<Eigen::Vector3d> path_;
  std::vector<double> way_;  ///< [m] Length of the path up to each point.
  double rise_ = 0.0;        ///< [s] Time up; the time down is the same.
  double duration_ = 0.0;
};

}  // namespace castaway::sim
