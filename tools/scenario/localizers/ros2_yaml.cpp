#include "tools/scenario/localizers/ros2_yaml.hpp"

#include <charconv>
#include <stdexcept>

#include <fmt/format.h>

#include "tools/scenario/sections/name_yaml.hpp"

namespace castaway::testbed {
namespace {

constexpr int kLastDomain = 232;  // Ports of higher ones do not exist.

void fields(Settings settings, Ros2Topics& topics) {
  settings.field({"scan", "", "Scans; of several lidars NAME/scan."}, topics.scan);
  settings.field({"points", "", "All layers of 3-D lidars; of several lidars NAME/points."},
                 topics.points);
  settings.field({"odom", "", "Odometry."}, topics.odom);
  settings.field({"imu", "", "Readings of the inertial measurement unit."}, topics.imu);
  settings.field({"tf", "", "Moving frames."}, topics.tf);
  settings.field({"tf_static", "", "Fixed frames."}, topics.tf_static);
  settings.field({"map", "", "The map."}, topics.map);
  settings.field({"initial_pose", "", "A start that is known."}, topics.initial_pose);
  settings.field({"pose", "", "The node's pose."}, topics.pose);
  settings.field({"particles", "", "The node's particles."}, topics.particles);
  settings.field({"command", "", "Velocities that drive the robot."}, topics.command);
}

void fields(Settings settings, Ros2Frames& frames) {
  settings.field({"map", "", "The map's frame."}, frames.map);
  settings.field({"odom", "", "Odometry's frame."}, frames.odom);
  settings.field({"base", "", "The robot's frame, on the floor."}, frames.base);
}

void fields(Settings settings, Ros2Config& config) {
  settings.field({"domain", "", "ROS_DOMAIN_ID.", {0, kLastDomain}}, config.domain);
  settings.field({"interface", "", "Network: loopback, any, or an interface such as eth0."},
                 config.interface);
  settings.field({"namespace", "", "Of topics whose names do not begin with a slash."},
                 config.name_space);
  settings.choice({"answer", "", "Where estimates come from: map->odom on /tf, or /amcl_pose."},
                  config.answer,
                  {{"transform", Ros2Answer::kTransform}, {"pose", Ros2Answer::kPose}});
  settings.field({"ahead_s", "s", "How long after its scan an answer is stamped.", {0.0, 60.0}},
                 config.ahead_s);
  settings.field({"timeout_s", "s", "Wall time for the answer to a scan.", {1e-3, 1e5}},
                 config.timeout_s);
  settings.field({"start_timeout_s", "s", "Wall time for the first answer.", {1e-3, 1e5}},
                 config.start_timeout_s);
  settings.field({"pace", "", "Times real time; 0: in lock step.", {0.0, 1e4}}, config.pace);
  settings.field(
      {"reliable_scans", "", "Scans and points are sent reliably, not with best effort."},
      config.reliable_scans);
  settings.field({"drive", "", "The robot follows /cmd_vel in place of its route."}, config.drive);
  settings.field(
      {"command_timeout_s", "s", "Without a command for so long, it stops.", {1e-3, 1e5}},
      config.command_timeout_s);
  fields(settings.group("topics"), config.topics);
  fields(settings.group("frames"), config.frames);
}

}  // namespace

bool is_node(const LocalizerSpec& spec) { return std::holds_alternative<Ros2Config>(spec.config); }

std::optional<LocalizerSpec> read_ros2(YamlReader& item, const ForeignRules& rules) {
  if (!item.is_map()) return std::nullopt;
  auto body = item.find("ros2");
  if (!body) return std::nullopt;
  Ros2Config config;
  fields(Settings::reading(*body), config);
  const bool trusted = rules.programs == FilePrograms::kAllowed || body->is_from_command_line();
  if (config.interface != "loopback" && !trusted) {
    body->fail("this file opens the network; add --allow-programs if you trust it");
  }
  LocalizerSpec spec;
  spec.relocalize_at_kidnap = item.get("global_localization_at_kidnap", false);
  spec.name = get_name(item, "name", "ros2");
  spec.config = std::move(config);
  return spec;
}

std::optional<LocalizerSpec> parse_ros2(const std::string& text) {
  if (text != "ros2" && !text.starts_with("ros2:")) return std::nullopt;
  Ros2Config config;
  if (text != "ros2") {
    const char* end = text.data() + text.size();
    const auto read = std::from_chars(text.data() + 5, end, config.domain);
    if (read.ec != std::errc{} || read.ptr != end || config.domain < 0 ||
        config.domain > kLastDomain) {
      throw std::invalid_argument(
          fmt::format("{}: needs a domain from 0 to {}, e.g. ros2:42", text, kLastDomain));
    }
  }
  return LocalizerSpec{"ros2", std::move(config)};
}

std::string ros2_yaml(const std::string& text) {
  const auto spec = parse_ros2(text);
  return fmt::format("{{ros2: {{domain: {}}}}}", std::get<Ros2Config>(spec.value().config).domain);
}

void describe_ros2(std::vector<SettingText>& texts) {
  Ros2Config config;
  fields(Settings::describing(texts, "localizers[].ros2."), config);
}

}  // namespace castaway::testbed
