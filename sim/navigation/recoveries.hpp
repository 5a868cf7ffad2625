/// Recovery behaviours of a robot that makes no progress: wait, re-plan, back up, spin.
#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "sim/common/geometry.hpp"
#include "sim/record/happening.hpp"

namespace castaway::sim {

/// Parameters of the recoveries.
struct RecoveryTimes {
  double patience = 10.0;  ///< [s] Without `progress` for this long, the next behaviour begins.
  /// [m] Displacement that counts as progress; both as in Nav2's progress checker.
  double progress = 0.5;
  double forget = 1.0;          ///< [m] After this displacement the sequence starts again.
  double wait = 3.0;            ///< [s] Length of a wait.
  double back_up = 0.3;         ///< [m] Distance to back up.
  double back_up_speed = 0.12;  ///< [m/s]
  double turn_rate = 0.6;       ///< [rad/s]
};

/// Watches the robot's progress, and takes over when there is none.
class Recoveries {
 public:
  /// `radius` [m]: of the robot with its margin. `period` [s]: between two calls of `watch` or
  /// `command`.
  Recoveries(const RecoveryTimes& times, double radius, double period)
      : times_(times), radius_(radius), period_(period) {}

  /// Returns the behaviour that begins now, if any. Called once a control period while the robot
  /// wants to move.
  std::optional<Recovery> watch(const Pose2& T_odom_base);
  /// Returns the velocity of the running behaviour; nothing if none runs. `p_base`: end points of
  /// the lidars.
  std::optional<Twist2> command(const Pose2& T_odom_base,
                                const std::vector<Eigen::Vector2d>& p_base);

 private:
  [[nodiscard]] std::optional<Twist2> wait() const;
  [[nodiscard]] std::optional<Twist2> back_up(const Pose2& T_begin_base,
                                              const std::vector<Eigen::Vector2d>& p_base) const;
  [[nodiscard]] std::optional<Twist2> spin(const Pose2& T_begin_base) const;
  void begin(Recovery recovery, const Pose2& T_odom_base,
             const std::vector<Eigen::Vector2d>& p_base);

  RecoveryTimes times_;
  double radius_;
  double period_;
  std::optional<Recovery> active_;
  bool fresh_ = false;    ///< The running behaviour has not commanded anything yet.
  Pose2 T_odom_begin_;    ///< Where the running behaviour began.
  double side_ = 1.0;     ///< Direction of a spin; 1 is left.
  double elapsed_ = 0.0;  ///< [s] Of the running behaviour, or since the last progress.
  std::size_t next_ = 0;  ///< Index of the behaviour to begin next.
  std::optional<Eigen::Vector2d> p_odom_progress_;  ///< Where the last progress was made.
  std::optional<Eigen::Vector2d> p_odom_stuck_;     ///< Where the robot got stuck last.
};

}  // namespace castaway::sim
