/// Applies the faults of a lidar to its scans.
#pragma once

#include <optional>
#include <vector>

#include "sim/events/fault.hpp"
#include "sim/sensor/lidar.hpp"

namespace castaway::sim {

/// The faults of one lidar. A fault applies to a scan if it is active at the stamp of the scan's
/// first beam.
class LidarFaults {
 public:
  /// Takes those of `faults` that concern the lidar. `open`: others may be added.
  LidarFaults(const std::vector<FaultSpec>& faults, const LidarConfig& lidar, bool open = false);
  /// Takes the fault if it concerns the lidar. Precondition: `open`.
  void add(const FaultSpec& fault);

  /// Returns the scan as delivered, with the time of delivery in `last_beam`; nothing if it is
  /// lost.
  std::optional<Sweep> deliver(Sweep sweep);

 private:
  void block(const FaultSpec& fault, LidarReading& reading) const;
  void apply(const FaultSpec& fault, Sweep& sweep) const;

  std::vector<FaultSpec> faults_;
  LidarConfig lidar_;
  bool open_;
  std::optional<LidarReading> last_;  ///< Newest scan before a freeze.
};

}  // namespace castaway::sim
