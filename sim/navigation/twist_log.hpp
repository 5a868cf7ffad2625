/// Velocity commands that were recorded.
#pragma once

#include <vector>

#include "sim/common/geometry.hpp"

namespace castaway::sim {

/// A command and when it was given.
struct TimedTwist {
  double t_s = 0.0;  ///< [s] Since the start of the run.
  Twist2 twist;
};

/// The command in force at a time: the last one given, none before the first. `log`: by time.
Twist2 twist_at(const std::vector<TimedTwist>& log, double t_s);

}  // namespace castaway::sim
