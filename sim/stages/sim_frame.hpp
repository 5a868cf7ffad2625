/// What a simulated run delivers.
#pragma once

#include <chrono>
#include <string>
#include <variant>
#include <vector>

#include <Eigen/Core>

#include "sim/common/geometry.hpp"
#include "sim/events/fault.hpp"
#include "sim/events/kidnap.hpp"
#include "sim/sensor/imu.hpp"
#include "sim/sensor/readings.hpp"

namespace castaway::sim {

/// The robot was lifted from the floor. A kidnap's record follows when it stands again.
struct PickUpRecord {
  std::chrono::nanoseconds stamp{};
  KidnapKind kind = KidnapKind::kCarry;
  Pose2 T_map_base;  ///< True pose of base.
};

/// The robot started a recovery or an emergency stop.
struct DriveRecord {
  std::chrono::nanoseconds stamp{};
  std::string what;  ///< "wait", "re-plan", "back up", "spin" or "emergency stop".
  Pose2 T_map_base;  ///< True pose of base.
};

/// The world changed.
struct WorldRecord {
  std::chrono::nanoseconds stamp{};
  std::string what;                      ///< As `to_string(WorldChange)`.
  std::string name;                      ///< Of an object or a door; empty: people came.
  std::vector<Eigen::Vector2d> outline;  ///< [m] Of what stands there now, in map; may be empty.
  Eigen::Vector2d z{0.0, 0.0};           ///< [m] Its lower and its upper end.
  Pose2 T_map_base;                      ///< True pose of base.
};

/// One delivery. A scan is delivered at the time of its last beam.
struct SimFrame {
  std::chrono::nanoseconds stamp{};
  std::variant<KidnapRecord, OdometryReading, LidarReading, PersonHit, FaultRecord, PickUpRecord,
               DriveRecord, WorldRecord, ImuReading>
      data;
};

}  // namespace castaway::sim
