/// Positions of a robot's joints in YAML.
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "tools/scenario/yaml/yaml_reader.hpp"

namespace castaway::testbed {

/// Reads the key `joints` of a robot: a map `{arm_lift: 0.1, elbow: -1.2}` in radians or metres, or
/// the name of a file beside the scenario, as `ros2 topic echo --once /joint_states` prints it:
/// lists `name` and `position` of one length.
std::map<std::string, double> read_joints(YamlReader& robot, const std::filesystem::path& folder);

/// The positions in such a file. Throws std::runtime_error naming it and the line.
std::map<std::string, double> read_joint_states(const std::filesystem::path& file);

}  // namespace castaway::testbed
