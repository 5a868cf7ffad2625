/// Joins the newest points of several lidars, as if they were seen at once.
#pragma once

#include <map>
#include <string>

#include "localization/sensor/scan_points.hpp"

namespace castaway::localization {

/// Stores the newest scan of every lidar.
class LidarPanorama {
 public:
  /// Scans of other lidars are used up to the age `memory`.
  explicit LidarPanorama(Stamp memory) : memory_(memory) {}

  /// Takes a scan of `lidar` with its points in base at `now`. Returns these points and the recent
  /// ones of the other lidars, moved to base at `now`.
  ScanPoints add(const std::string& lidar, const ScanPoints& points, Stamp now,
                 const SE2& T_odom_base);
  void clear() { newest_.clear(); }

 private:
  struct Entry {
    Stamp stamp{};
    SE2 T_odom_base;
    ScanPoints points;
  };
  Stamp memory_;
  std::map<std::string, Entry> newest_;
};

}  // namespace castaway::localization
