#include "sim/robot/urdf/urdf_tree.hpp"

#include <map>
#include <set>
#include <stdexcept>

#include <fmt/format.h>

#include "xacro/files/xml_text.hpp"

namespace castaway::sim {
namespace {

/// The joint and parent of a link.
struct ParentJoint {
  std::string joint;
  std::string parent;  ///< Parent link.
};

std::string text_of(const TiXmlElement* element, const char* name) {
  return element == nullptr ? "" : attribute(*element, name);
}

/// Joint and parent of each link.
std::map<std::string, ParentJoint> parent_joints(const TiXmlElement& robot,
                                                 const std::string& path) {
  std::map<std::string, ParentJoint> result;
  for (auto* joint = robot.FirstChildElement("joint"); joint != nullptr;
       joint = joint->NextSiblingElement("joint")) {
    const std::string name = text_of(joint, "name");
    const std::string child = text_of(joint->FirstChildElement("child"), "link");
    const std::string parent = text_of(joint->FirstChildElement("parent"), "link");
    const auto [hanger, fresh] = result.insert({child, {name, parent}});
    if (!fresh) {
      throw std::runtime_error(
          fmt::format("{}: link {} hangs on two joints, {} and {}: remove one of them", path, child,
                      hanger->second.joint, name));
    }
  }
  return result;
}

}  // namespace

void require_tree(const TiXmlElement& robot, const std::string& path) {
  const std::map<std::string, ParentJoint> joints = parent_joints(robot, path);
  std::set<std::string> sound;
  for (const auto& [link, hanger] : joints) {
    std::set<std::string> climbed;
    std::string at = link;
    while (joints.contains(at) && !sound.contains(at)) {
      if (!climbed.insert(at).second) {
        throw std::runtime_error(
            fmt::format("{}: the joints above link {} form a loop (joint {}): a robot is a tree; "
                        "remove one of them",
                        path, at, joints.at(at).joint));
      }
      at = joints.at(at).parent;
    }
    sound.merge(climbed);
  }
}

}  // namespace castaway::sim
