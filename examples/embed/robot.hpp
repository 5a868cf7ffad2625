/// Stands for a robot: drives about, sends messages, and is carried elsewhere once.
#pragma once

#include <variant>

#include <castaway/grid.hpp>
#include <castaway/pose.hpp>

#include "messages.hpp"

using Message = std::variant<WheelMessage, SweepMessage>;

class Robot {
 public:
  explicit Robot(castaway::OccupancyGrid plan);

  /// The next message. The wheels send 50 a second, the lidar ten.
  Message next();
  /// Where it really is: what no robot knows, for the comparison at the end.
  [[nodiscard]] const castaway::Pose2& T_map_base() const { return T_map_base_; }
  /// Somebody puts it down elsewhere; its wheels do not notice.
  void carry(const castaway::Pose2& T_map_base) { T_map_base_ = T_map_base; }

 private:
  void drive();
  [[nodiscard]] double room_ahead() const;
  [[nodiscard]] SweepMessage sweep() const;

  castaway::OccupancyGrid plan_;
  castaway::Pose2 T_map_base_{1.5, 2.0, 0.0};
  castaway::Pose2 T_odom_base_;
  bool turning_ = false;
  int ticks_ = 0;
};
