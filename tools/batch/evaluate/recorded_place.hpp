/// A recorded log with its maps, from a folder.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "localization/space/volume/volume.hpp"
#include "tools/base/formats/ros_map.hpp"
#include "tools/build/recorded/recorded_source.hpp"
#include "tools/scenario/sections/scenario.hpp"

namespace castaway::testbed {

/// A log with its maps.
struct RecordedPlace {
  std::string name;
  Frames frames;
  RosMap map;                              ///< Without cells: there is none.
  std::vector<std::string> warnings = {};  ///< Of the bag.
  std::string map_file = {};               ///< Its YAML file; empty: the map is the bag's.
  /// As `LocalizerPlace::volume`; empty: there is no 3-D map.
  std::function<std::shared_ptr<const localization::Volume>(double voxel)> volume = {};
};

/// A 3-D map and how a log lies in it.
struct Map3dOfPlace {
  std::string file{};  ///< Empty: it is in the folder.
  /// [m] Height above the ground of the odometry's frame, in CARMEN logs, which need it, of the
  /// lidar; nothing: that of base_footprint.
  std::optional<double> base_height{};
};

/// Maps that a place must have.
struct PlaceMaps {
  bool planar = true;
  std::optional<Map3dOfPlace> map3d{};
  SE2 T_map_truth{};  ///< Of the frame in which the log's true poses are.
};

/// The maps that localizers work on. Throws std::invalid_argument if `map3d` states something and
/// none of them works on a 3-D map.
PlaceMaps maps_for(const std::vector<LocalizerSpec>& localizers, const Map3dOfPlace& map3d);

/// Reads a log and its maps from a folder. The log is the first by name of `log`, `*.log`,
/// `*.carmen` and `*.clf` (each also with `.gz`), or else a bag (`*.mcap`, `*.db3`, `bag/`). The
/// planar map is `map.yaml`, `map/map.yaml`, else the only .yaml file, else the bag's map; the 3-D
/// map is the only file of those of `is_map3d_source`. castaway's own run folders with
/// `outputs.carmen` or `outputs.bag` qualify. Throws std::runtime_error naming what is missing.
RecordedPlace load_recorded_place(const std::string& folder, const PlaceMaps& maps = {});

/// Reads a CARMEN log or a bag, and a ROS map by its YAML file; without one, the map of a bag.
/// Throws std::runtime_error naming what is missing.
RecordedPlace load_recorded_log(const std::string& log, const std::string& map);

}  // namespace castaway::testbed
