#include "tools/build/build_robot.hpp"

#include <regex>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "tools/base/files/file.hpp"
#include "tools/build/scan_truth.hpp"
#include "tools/scenario/files/data_paths.hpp"
#include "tools/scenario/yaml/yaml_tree.hpp"

namespace castaway::testbed {
namespace {

constexpr std::size_t kMaxYamlBytes = 1U << 20U;

using xacro::Dict;
using xacro::List;
using xacro::Value;

Value to_value(const YamlNode& node) {
  if (node.kind == YamlNode::Kind::kScalar) return xacro::from_literal(node.scalar);
  if (node.kind == YamlNode::Kind::kList) {
    List list;
    for (const YamlNode& item : node.items) list.push_back(to_value(item));
    return {list};
  }
  if (node.kind == YamlNode::Kind::kNull) return {};
  Dict dict;
  for (const YamlEntry& entry : node.entries) dict.push_back({entry.key, to_value(entry.value)});
  return {dict};
}

/// Rejects tags such as `!degrees`: they would be dropped, and the values would be wrong.
Value read_robot_yaml(const std::string& path) {
  const std::string text = read_file(path);
  const bool tagged = std::regex_search(text, std::regex(R"(:\s+!\w)"));
  if (tagged || text.size() > kMaxYamlBytes) {
    throw std::runtime_error(fmt::format(
        "{}: {}", path,
        tagged ? "tags like !degrees are not supported: write the value in radians and metres"
               : "larger than 1 MiB: no robot's parameters"));
  }
  return to_value(parse_yaml(text, path));
}

}  // namespace

sim::RobotOptions robot_options(const RobotSpec& spec, const std::filesystem::path& base) {
  sim::RobotOptions options;
  options.arguments = spec.arguments;
  options.joints = spec.joints;
  for (const std::string& path : spec.search_paths) {
    const bool from_base = std::filesystem::is_directory(base / path);
    options.search_paths.push_back(from_base ? (base / path).string() : path);
  }
  options.read_yaml = read_robot_yaml;
  return options;
}

sim::RobotModel build_robot(const RobotSpec& spec, const std::filesystem::path& base) {
  return sim::load_robot(find_robot(spec.file, base).string(), robot_options(spec, base));
}

RobotFacts robot_facts(const RobotSpec& spec, const std::filesystem::path& base,
                       const sim::RobotModel& robot) {
  return {robot.frames, sim::expand_robot(robot.path, robot_options(spec, base)).urdf};
}

void tell_robot(const RobotSpec& spec, const std::filesystem::path& base,
                const sim::SimulationConfig& config, BridgeConfig& bridge) {
  RobotFacts robot = robot_facts(spec, base, config.robot);
  bridge.messages.links = std::move(robot.links);
  bridge.messages.lidars = bag_lidars(lidars_of(config.lidars));
  bridge.description = std::move(robot.description);
}

}  // namespace castaway::testbed
