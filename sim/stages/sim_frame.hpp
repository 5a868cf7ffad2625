/// What a simulated run delivers.
#pragma once

#include <chrono>
#include <variant>

#include "sim/common/geometry.hpp"
#include "sim/events/kidnap.hpp"
#include "sim/record/happening.hpp"
#include "sim/sensor/imu.hpp"
#include "sim/sensor/readings.hpp"

namespace castaway::sim {

/// What happened to the robot or around it.
struct HappeningRecord {
  std::chrono::nanoseconds stamp{};
  Happening what;
  Pose2 T_map_base;  ///< True pose of base.
};

/// One delivery. A scan is delivered at the time of its last beam.
struct SimFrame {
  std::chrono::nanoseconds stamp{};
  std::variant<KidnapRecord, OdometryReading, LidarReading, HappeningRecord, ImuReading> data;
};

}  // namespace castaway::sim
