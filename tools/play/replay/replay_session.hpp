/// What `castaway replay` plays, as YAML: a log, localizers, and what happens on the way.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "tools/build/recorded/carmen_source.hpp"
#include "tools/build/recorded/spliced_source.hpp"
#include "tools/ros/bag_topics.hpp"
#include "tools/run/localizer_order.hpp"
#include "tools/scenario/localizers/foreign_yaml.hpp"
#include "tools/scenario/sections/scenario.hpp"
#include "tools/scenario/yaml/yaml_reader.hpp"

namespace castaway::testbed {

/// A replay:
///
///     log: intel.log.gz             # CARMEN log or bag
///     map: intel.yaml               # of a bag: in place of its own
///     map3d: intel.map3d            # 3-D map; left out: none
///     start: unknown                # truth, unknown
///     from_scan: 0
///     scans: ~                      # how many; ~: all
///     scans_used: all               # all, even, odd
///     scan_topics: []               # of a bag; as --scan-topic
///     odom_topic: ""
///     truth_topic: ""
///     points_topics: [/points]      # PointCloud2; left out: with a 3-D map by type, else none
///     imu_topic: /imu               # left out: with a 3-D map the only one, else none
///     clock_offset: 0.5             # [s] of a bag's scans ahead of its odometry; left out: 0
///     base_height: 0.1              # [m] of base above the ground; left out: of a bag by its tree
///     truth_in_map: [1.5, 2, 0.1]   # x, y [m], yaw [rad] of the truth's frame; left out: map
///     seed: 1
///     localizers: [mh_amcl]         # as in a scenario
///     events:
///       - splice: {after_scans: 120, to_scan: 900}
///       - localizer: {name: mh_amcl, do: relocalize, at_s: 30}
///
/// A splice goes on from scan `to_scan` of the log once `after_scans` scans have been played.
struct ReplaySession {
  std::string log;
  std::string map;    ///< Empty: the bag's own.
  std::string map3d;  ///< Empty: none.
  bool known_start = false;
  /// `from_scan`: of the log; the other numbers: of the scans that are used.
  SplicedPart part;
  CarmenSourceConfig::Scans scans_used = CarmenSourceConfig::Scans::kAll;
  BagTopicOptions topics;
  std::optional<double> base_height;  ///< [m] Of base above the ground; nothing: of a bag by /tf.
  SE2 T_map_truth;                    ///< Of the frame in which the log's true poses are.
  std::uint64_t seed = 1;
  std::vector<LocalizerSpec> localizers;  ///< By default `mh_amcl`, on a 3-D map in mode 3d.
  std::vector<LocalizerOrder> orders;     ///< In order of time.
  YamlNode tree;                          ///< All of it, with defaults filled in.
};

/// Reads a session. Throws std::runtime_error or std::invalid_argument naming file, line and key.
ReplaySession read_session(YamlDocument document, const ForeignRules& rules = {});

}  // namespace castaway::testbed
