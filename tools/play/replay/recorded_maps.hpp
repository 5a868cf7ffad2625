/// The maps of a replay: a planar one, a 3-D one, or both.
#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "localization/space/volume/volume.hpp"
#include "tools/base/formats/level_map.hpp"
#include "tools/base/formats/ros_map.hpp"
#include "tools/play/replay/replay_session.hpp"

namespace castaway::testbed {

/// Maps that localizers and pictures use.
struct RecordedMaps {
  /// Without any planar map, the `ground_plan` of the 3-D map, which no localizer uses.
  RosMap planar;
  /// As `LocalizerPlace::volume`; empty: there is no 3-D map.
  std::function<std::shared_ptr<const localization::Volume>(double voxel)> volume{};
  std::shared_ptr<const LevelMaps> levels{};  ///< Of the 3-D map, for pages; null: there is none.
};

/// Checks which maps the session names, before they are opened. Throws as `open_maps`.
void check_maps(const ReplaySession& session);

/// Opens the maps that the session names. `own` is the planar map that the log holds; one that the
/// session names is used in its place. `wheels`: of the robot that drove. Throws std::runtime_error
/// or std::invalid_argument naming the file, or the map that is missing.
RecordedMaps open_maps(const ReplaySession& session, const std::optional<RosMap>& own,
                       const localization::WheelStance& wheels = {});

}  // namespace castaway::testbed
