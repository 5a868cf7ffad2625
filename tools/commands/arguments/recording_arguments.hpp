/// Options that name the maps of a recorded log and the topics of a bag.
#pragma once

#include <optional>
#include <string>

#include "tools/commands/arguments/command_line.hpp"
#include "tools/ros/bag_topics.hpp"
#include "tools/scenario/yaml/yaml_tree.hpp"

namespace castaway::testbed {

/// Values from the command line.
struct RecordingArguments {
  std::string map;
  std::string map3d;
  BagTopicOptions topics;
  std::optional<double> base_height;
  std::string truth_in_map;  ///< "X,Y,YAW".

  /// The first option that was given, such as "--map3d"; empty: none was.
  [[nodiscard]] std::string first_given() const;
};

/// The options --map, --map3d, --scan-topic, --odom-topic, --truth-topic, --points-topic,
/// --imu-topic, --base-height and --truth-in-map.
void add_recording_options(Command& command, RecordingArguments& arguments);

/// Appends the maps, or the topics, the height of base and the truth's frame, to the map of a
/// `ReplaySession`.
void put_maps(const RecordingArguments& arguments, YamlNode& session);
void put_topics(const RecordingArguments& arguments, YamlNode& session);

}  // namespace castaway::testbed
