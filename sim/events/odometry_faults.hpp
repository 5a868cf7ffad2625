/// Applies the faults of odometry to wheels and readings.
#pragma once

#include <chrono>
#include <vector>

#include "sim/events/fault.hpp"

namespace castaway::sim {

/// Factors of the true increments of the wheels.
struct WheelGain {
  double left = 1.0;
  double right = 1.0;

  /// True if neither encoder counts.
  [[nodiscard]] bool frozen() const { return left == 0.0 && right == 0.0; }
};

/// The faults of odometry during a run.
class OdometryFaults {
 public:
  /// Takes those of `faults` that concern odometry.
  explicit OdometryFaults(const std::vector<FaultSpec>& faults);
  /// Takes the fault if it concerns odometry.
  void add(const FaultSpec& fault);

  /// Gain of all active faults together; 1 without any.
  [[nodiscard]] WheelGain gain(std::chrono::nanoseconds stamp) const;
  /// True while no readings arrive.
  [[nodiscard]] bool is_lost(std::chrono::nanoseconds stamp) const;
  /// True once for every reset, at the first call at or after its time.
  bool reset_due(std::chrono::nanoseconds stamp);

 private:
  std::vector<FaultSpec> faults_;
  std::vector<FaultSpec> resets_;  ///< Those that are still to come.
};

}  // namespace castaway::sim
