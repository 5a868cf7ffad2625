/// What a lidar's faults make of its scans.
#pragma once

#include <optional>
#include <vector>

#include "sim/events/fault.hpp"
#include "sim/sensor/lidar.hpp"

namespace castaway::sim {

/// The faults of one lidar. Scans are held against the time of their first beam.
class LidarFaults {
 public:
  /// Takes those of `faults` that are of the lidar.
  LidarFaults(const std::vector<FaultSpec>& faults, const LidarConfig& lidar);

  /// The scan as it is delivered, `last_beam` being the time of delivery; nothing: it is lost.
  std::optional<Sweep> passed(Sweep sweep);

 private:
  void block(const FaultSpec& fault, LidarReading& reading) const;
  void apply(const FaultSpec& fault, Sweep& sweep) const;

  std::vector<FaultSpec> faults_;
  LidarConfig lidar_;
  std::optional<LidarReading> last_;  ///< Newest scan outside of a freeze.
};

}  // namespace castaway::sim
