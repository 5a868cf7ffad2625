#include "tools/scenario/sections/joint_states.hpp"

#include <fmt/format.h>

namespace castaway::testbed {

std::map<std::string, double> read_joint_states(const std::filesystem::path& file) {
  YamlDocument document = YamlDocument::load(file);
  YamlReader root = document.root();
  const auto names = root.require<std::vector<std::string>>("name");
  const auto positions = root.require<std::vector<double>>("position");
  if (names.size() != positions.size()) {
    root.find("position")
        ->fail(fmt::format("{} positions for {} names: not the joint states of "
                           "one message",
                           positions.size(), names.size()));
  }
  std::map<std::string, double> joints;
  for (std::size_t i = 0; i < names.size(); ++i) joints[names[i]] = positions[i];
  return joints;
}

std::map<std::string, double> read_joints(YamlReader& robot, const std::filesystem::path& folder) {
  std::map<std::string, double> joints;
  const auto given = robot.find("joints");
  if (!given) return joints;
  if (given->is_scalar()) return read_joint_states(folder / given->as<std::string>());
  for (auto& [name, value] : robot.child("joints").entries()) joints[name] = value.as<double>();
  return joints;
}

}  // namespace castaway::testbed
