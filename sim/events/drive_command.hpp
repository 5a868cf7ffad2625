/// Commands that replace a robot's route for a time.
#pragma once

#include <optional>

#include "sim/common/geometry.hpp"

namespace castaway::sim {

/// From `at_s` on the robot is driven so.
struct DriveCommand {
  double at_s = 0.0;            ///< [s] Since the start of the run.
  std::optional<Twist2> twist;  ///< Nothing: by its route again.
};

/// @throws std::invalid_argument naming the field and the remedy.
void validate(const DriveCommand& command);

}  // namespace castaway::sim
