/// What a robot does that does not get on: wait, plan anew, back up, look around.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "sim/common/geometry.hpp"

namespace castaway::sim {

/// A recovery behaviour, in the order in which they are tried.
enum class Recovery : std::uint8_t {
  kWait,    ///< Stands still: whoever is in the way may go.
  kReplan,  ///< Plans around what the lidar sees.
  kBackUp,  ///< Drives back a little.
  kSpin,    ///< Turns a quarter to the roomier side.
};

/// "wait", "re-plan", "back up", "spin": as logs name it.
std::string to_string(Recovery recovery);

/// How recoveries go.
struct RecoveryTimes {
  double patience = 10.0;       ///< [s] Without `progress`, the next behaviour begins...
  double progress = 0.5;        ///< [m] ...as with the progress checker of Nav2, its defaults.
  double forget = 1.0;          ///< [m] After so much way it begins with the first one again.
  double wait = 3.0;            ///< [s]
  double back_up = 0.3;         ///< [m]
  double back_up_speed = 0.12;  ///< [m/s]
  double turn_rate = 0.6;       ///< [rad/s]
};

/// Watches the way made, and takes over where there is none.
class Recoveries {
 public:
  /// `radius` [m]: the robot's with its margin. `period` [s] between two calls of `step`.
  Recoveries(const RecoveryTimes& times, double radius, double period)
      : times_(times), radius_(radius), period_(period) {}

  /// Once a control period, while the robot wants to move. The behaviour that begins now, if any.
  std::optional<Recovery> watch(const Pose2& T_odom_base);
  /// The velocity of the behaviour under way; nothing: none is. `p_base`: what the lidar sees.
  std::optional<Twist2> command(const Pose2& T_odom_base,
                                const std::vector<Eigen::Vector2d>& p_base);

 private:
  [[nodiscard]] std::optional<Twist2> waiting() const;
  [[nodiscard]] std::optional<Twist2> backing_up(const Pose2& T_begin_base,
                                                 const std::vector<Eigen::Vector2d>& p_base) const;
  [[nodiscard]] std::optional<Twist2> spinning(const Pose2& T_begin_base) const;
  void begin(Recovery recovery, const Pose2& T_odom_base,
             const std::vector<Eigen::Vector2d>& p_base);

  RecoveryTimes times_;
  double radius_;
  double period_;
  std::optional<Recovery> active_;
  bool fresh_ = false;                              ///< It has not commanded anything yet.
  Pose2 T_odom_begin_;                              ///< Where it began.
  double side_ = 1.0;                               ///< Of a spin; 1: left.
  double elapsed_ = 0.0;                            ///< [s] Of it, or since the last progress.
  std::size_t next_ = 0;                            ///< Behaviour to begin next.
  std::optional<Eigen::Vector2d> p_odom_progress_;  ///< Where the last progress was made...
  std::optional<Eigen::Vector2d> p_odom_stuck_;     ///< ...and where it got stuck last.
};

}  // namespace castaway::sim
