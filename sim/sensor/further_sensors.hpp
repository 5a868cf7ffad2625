/// Sensors that a robot may have besides lidars and encoders.
#pragma once

#include <optional>

#include "sim/sensor/imu.hpp"

namespace castaway::sim {

/// Nothing: the robot has none.
struct FurtherSensors {
  std::optional<ImuConfig> imu{};
};

}  // namespace castaway::sim
