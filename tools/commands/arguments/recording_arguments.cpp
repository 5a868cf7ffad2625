#include "tools/commands/arguments/recording_arguments.hpp"

#include <initializer_list>
#include <utility>

#include "tools/scenario/yaml/yaml_reader.hpp"

namespace castaway::testbed {
namespace {

void put_key(YamlNode& session, const std::string& key, YamlNode value) {
  session.entries.push_back({key, std::move(value)});
}

}  // namespace

std::string RecordingArguments::first_given() const {
  const std::initializer_list<std::pair<const char*, bool>> options = {
      {"--map", !map.empty()},
      {"--map3d", !map3d.empty()},
      {"--scan-topic", !topics.scans.empty()},
      {"--odom-topic", !topics.odometry.empty()},
      {"--truth-topic", !topics.truth.empty()},
      {"--points-topic", !topics.clouds.empty()},
      {"--imu-topic", !topics.imu.empty()},
      {"--clock-offset", topics.clock_offset != 0.0},
      {"--base-height", base_height.has_value()},
      {"--truth-in-map", !truth_in_map.empty()}};
  for (const auto& [option, given] : options) {
    if (given) return option;
  }
  return "";
}

void add_recording_options(Command& command, RecordingArguments& arguments) {
  command.add_option("--map", arguments.map,
                     "ROS map (.yaml) of a log; of a bag, instead of its own");
  command.add_option(
      "--map3d", arguments.map3d,
      "3-D map for mh_amcl:3d: .map3d, OctoMap's .bt or .ot, or a cloud (.pcd, .ply)");
  command
      .add_option("--scan-topic", arguments.topics.scans,
                  "LaserScan topic of a bag; repeat for several")
      .repeatable();
  command.add_option("--odom-topic", arguments.topics.odometry,
                     "Odometry topic of a bag, or its /tf (default: by type, else /tf)");
  command.add_option("--truth-topic", arguments.topics.truth,
                     "Topic of a bag's true pose (default: /ground_truth/odom, if there is one)");
  command
      .add_option(
          "--points-topic", arguments.topics.clouds,
          "PointCloud2 topic of a bag's 3-D lidar; repeat for several (default: with --map3d those "
          "of castaway's own bags, or the only one of a bag without LaserScan)")
      .repeatable();
  command.add_option("--imu-topic", arguments.topics.imu,
                     "Imu topic of a bag, or none (default: with --map3d by type, else none)");
  command
      .add_option("--clock-offset", arguments.topics.clock_offset,
                  "By how much the scans of a bag are stamped ahead of its odometry [s]; it is "
                  "subtracted from their stamps")
      .range(-60.0, 60.0);
  command
      .add_option(
          "--base-height", arguments.base_height,
          "With --map3d: height of the odometry's frame above the ground, in CARMEN logs that of "
          "the lidar [m] (default, in bags: above base_footprint)")
      .range(-10.0, 10.0);
  command.add_option("--truth-in-map", arguments.truth_in_map,
                     "X,Y,YAW [m, rad]: pose in the map of the frame of the true poses "
                     "(default: the map's own frame)");
}

void put_maps(const RecordingArguments& arguments, YamlNode& session) {
  put_key(session, "map", write_yaml(arguments.map));
  if (!arguments.map3d.empty()) put_key(session, "map3d", write_yaml(arguments.map3d));
}

void put_topics(const RecordingArguments& arguments, YamlNode& session) {
  const BagTopicOptions& topics = arguments.topics;
  put_key(session, "scan_topics", write_yaml(topics.scans));
  put_key(session, "odom_topic", write_yaml(topics.odometry));
  put_key(session, "truth_topic", write_yaml(topics.truth));
  if (!topics.clouds.empty()) put_key(session, "points_topics", write_yaml(topics.clouds));
  if (!topics.imu.empty()) put_key(session, "imu_topic", write_yaml(topics.imu));
  if (topics.clock_offset != 0.0) {
    put_key(session, "clock_offset", write_yaml(topics.clock_offset));
  }
  if (arguments.base_height) {
    put_key(session, "base_height", write_yaml(*arguments.base_height));
  }
  if (arguments.truth_in_map.empty()) return;
  put_key(session, "truth_in_map",
          parse_yaml("[" + arguments.truth_in_map + "]", "--truth-in-map"));
}

}  // namespace castaway::testbed
