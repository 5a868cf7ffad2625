/// Several lidars as one: the newest points of all of them, as if seen at once.
#pragma once

#include <map>
#include <string>

#include "localization/sensor/scan_points.hpp"

namespace castaway::localization {

/// Keeps the newest scan of every lidar.
class LidarPanorama {
 public:
  /// Scans of other lidars are used for so long.
  explicit LidarPanorama(Stamp memory) : memory_(memory) {}

  /// Takes a scan of `lidar`, its points in base as it is at `now`. Gives these points and those of
  /// the other lidars that are not too old, moved to base as it is now.
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
