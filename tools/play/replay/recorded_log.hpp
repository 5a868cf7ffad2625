/// Opens the log of a replay, a CARMEN log or a bag, and its maps.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "localization/space/volume/volume.hpp"
#include "tools/base/formats/level_map.hpp"
#include "tools/base/formats/ros_map.hpp"
#include "tools/build/foreign/lidar_facts.hpp"
#include "tools/play/replay/replay_session.hpp"
#include "tools/run/run_sink.hpp"

namespace castaway::testbed {

/// Contents of a log.
struct RecordedLog {
  std::shared_ptr<const Frames> frames;
  RosMap map;
  /// The 3-D map, as `LocalizerPlace::volume`; empty: there is none.
  std::function<std::shared_ptr<const localization::Volume>(double voxel)> volume{};
  std::shared_ptr<const LevelMaps> levels{};  ///< Its floors, for pages; null: there is none.
  std::optional<SE2> start;        ///< Start pose given to the localizers, in castaway's own bags.
  std::vector<LidarFacts> lidars;  ///< Of a bag.
  std::vector<std::string> warnings;
};

/// Checks what can be known before files are read. Throws std::invalid_argument for settings that
/// do not go together, std::runtime_error naming a file that is missing.
void check_log(const ReplaySession& session);

/// Reads the log, and its maps, into memory. Throws std::runtime_error naming the file, or
/// std::invalid_argument for settings that it cannot have.
RecordedLog open_log(const ReplaySession& session);

/// "replay-<map>": the name of its runs.
std::string replay_name(const RecordedLog& log);

/// Facts of the run.
RunInfo run_info(const ReplaySession& session, const RecordedLog& log);

/// The log's source that plays the session.
std::unique_ptr<SplicedSource> spliced_source(const RecordedLog& log, const ReplaySession& session);

/// The initial pose that the session gives to its localizers; nothing: unknown. Throws
/// std::runtime_error if it is the true one, which the log does not hold.
std::optional<localization::PoseWithCovariance> initial_pose(const ReplaySession& session,
                                                             const RecordedLog& log,
                                                             const SplicedSource& source);

}  // namespace castaway::testbed
