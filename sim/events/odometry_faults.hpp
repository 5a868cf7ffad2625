/// What the faults of odometry make of its wheels and readings.
#pragma once

#include <chrono>
#include <vector>

#include "sim/events/fault.hpp"

namespace castaway::sim {

/// What each wheel's true increments are multiplied with.
struct WheelGain {
  double left = 1.0;
  double right = 1.0;

  /// True if both wheels stand still for the encoders.
  [[nodiscard]] bool frozen() const { return left == 0.0 && right == 0.0; }
};

/// The faults of odometry on the run's clock.
class OdometryFaults {
 public:
  /// Takes those of `faults` that are of odometry.
  explicit OdometryFaults(const std::vector<FaultSpec>& faults);

  /// Of all faults at a time; 1 without any.
  [[nodiscard]] WheelGain gain(std::chrono::nanoseconds stamp) const;
  /// True while readings do not arrive.
  [[nodiscard]] bool lost(std::chrono::nanoseconds stamp) const;
  /// True once for every reset, at the first call at or after its time.
  bool reset_due(std::chrono::nanoseconds stamp);

 private:
  std::vector<FaultSpec> faults_;
  std::vector<FaultSpec> resets_;  ///< Still to come.
};

}  // namespace castaway::sim
