#include "tools/scenario/sections/scenario.hpp"

#include "tools/scenario/yaml/yaml_reader.hpp"

namespace castaway::testbed {

LidarSpec& LidarSpec::set(const std::string& key, double value) {
  changes.kind = YamlNode::Kind::kMap;
  put_value(changes, key, write_yaml(value), "lidar");
  return *this;
}

LidarSpec& LidarSpec::set(const std::string& key, const Eigen::Vector3d& value) {
  changes.kind = YamlNode::Kind::kMap;
  put_value(changes, key, write_yaml(value), "lidar");
  return *this;
}

std::vector<std::string> names_of(const std::vector<LocalizerSpec>& localizers) {
  std::vector<std::string> names;
  for (const LocalizerSpec& spec : localizers) names.push_back(spec.name);
  return names;
}

}  // namespace castaway::testbed
