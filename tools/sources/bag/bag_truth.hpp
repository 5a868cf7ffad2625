/// True poses of base in a bag, by time.
#pragma once

#include <map>
#include <optional>

#include "tools/run/frame.hpp"

namespace castaway::testbed {

/// Poses of one topic, interpolated over at most half a second and never across a kidnap. Another
/// topic may state the exact pose of each scan.
class BagTruth {
 public:
  void add(Stamp stamp, const SE2& T_map_base) { poses_[stamp] = T_map_base; }
  void add_of_scan(Stamp stamp, const SE2& T_map_base) { of_scans_[stamp] = T_map_base; }

  /// The true pose at a time; nothing if unknown.
  [[nodiscard]] std::optional<SE2> at(Stamp stamp) const;
  /// The true pose of the scan with this stamp; nothing if unknown.
  [[nodiscard]] std::optional<SE2> of_scan(Stamp stamp) const;

 private:
  std::map<Stamp, SE2> poses_;
  std::map<Stamp, SE2> of_scans_;
};

}  // namespace castaway::testbed
