/// Joint positions of a robot, as YAML.
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "tools/scenario/yaml/yaml_reader.hpp"

namespace castaway::testbed {

/// Reads the key `joints` of a robot: a map `{arm_lift: 0.1, elbow: -1.2}` in radians or metres, or
/// the name of a file relative to the scenario, as printed by `ros2 topic echo --once
/// /joint_states`: lists `name` and `position` of equal length.
std::map<std::string, double> read_joints(YamlReader& robot, const std::filesystem::path& folder);

/// Reads such a file. Throws std::runtime_error naming it and the line.
std::map<std::string, double> read_joint_states(const std::filesystem::path& file);

}  // namespace castaway::testbed
