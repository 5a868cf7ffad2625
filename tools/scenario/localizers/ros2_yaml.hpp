/// Reads localizers that are nodes of ROS 2.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tools/scenario/localizers/foreign_yaml.hpp"
#include "tools/scenario/sections/scenario.hpp"
#include "tools/scenario/yaml/settings.hpp"

namespace castaway::testbed {

/// True if the localizer is a node of ROS 2.
bool is_node(const LocalizerSpec& spec);

/// Reads `{name, ros2: {...}}`; nothing for another form. Fails, naming --allow-programs, if a file
/// that is not trusted names a network interface.
std::optional<LocalizerSpec> read_ros2(YamlReader& item, const ForeignRules& rules);

/// Parses `ros2` or `ros2:DOMAIN` of the command line; nothing for another text. Throws
/// std::invalid_argument.
std::optional<LocalizerSpec> parse_ros2(const std::string& text);

/// The same as an element of a scenario's list, in YAML's flow style.
std::string ros2_yaml(const std::string& text);

/// Appends the settings.
void describe_ros2(std::vector<SettingText>& texts);

}  // namespace castaway::testbed
