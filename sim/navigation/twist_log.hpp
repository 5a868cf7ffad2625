/// A log of velocity commands.
#pragma once

#include <vector>

#include "sim/common/geometry.hpp"

namespace castaway::sim {

/// A velocity command and its time.
struct TimedTwist {
  double t_s = 0.0;  ///< [s] Since the start of the run.
  Twist2 twist;
};

/// The command in force at a time: the last one given, zero before the first. `log` is ordered by
/// time.
Twist2 twist_at(const std::vector<TimedTwist>& log, double t_s);

}  // namespace castaway::sim
