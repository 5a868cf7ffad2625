#include "sim/robot/urdf/urdf_file.hpp"

#include <cmath>
#include <map>
#include <set>
#include <stdexcept>

#include <console_bridge/console.h>
#include <fmt/format.h>

#include "sim/robot/urdf/urdf_repairs.hpp"
#include "xacro/expand.hpp"
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

constexpr std::size_t kMaxLinks = 2000;
constexpr double kMaxOffset = 1000.0;  // [m]

/// Collects the messages that urdfdom would print.
class ConsoleCapture : public console_bridge::OutputHandler {
 public:
  ConsoleCapture() { console_bridge::useOutputHandler(this); }
  ~ConsoleCapture() override { console_bridge::restorePreviousOutputHandler(); }
  ConsoleCapture(const ConsoleCapture&) = delete;
  ConsoleCapture& operator=(const ConsoleCapture&) = delete;

  void log(const std::string& text, console_bridge::LogLevel level, const char*, int) override {
    if (level < console_bridge::CONSOLE_BRIDGE_LOG_ERROR) return;
    if (!errors_.empty()) errors_ += "; ";
    for (const char c : text) errors_ += c == '\n' ? ' ' : c;
  }
  [[nodiscard]] const std::string& errors() const { return errors_; }

 private:
  std::string errors_;
};

urdf::ModelInterfaceSharedPtr parse(const UrdfFile& file) {
  if (file.xml->RootElement()->FirstChildElement("link") == nullptr) {
    throw std::runtime_error(
        file.path + ": not a valid URDF: it has no <link>; if it defines macros only, give the " +
        "file that calls them");
  }
  const ConsoleCapture console;
  urdf::ModelInterfaceSharedPtr model;
  std::string problem;
  try {
    model = urdf::parseURDF(xml_text_of(*file.xml));
    problem = console.errors();
  } catch (const std::exception& error) {
    problem = error.what();
  }
  if (model && model->getRoot() && problem.empty()) return model;
  throw std::runtime_error(fmt::format("{}: not a valid URDF: {}", file.path,
                                       problem.empty() ? "it has no links" : problem));
}

void require_sound(const UrdfFile& file) {
  if (file.model->links_.size() > kMaxLinks) {
    throw std::runtime_error(fmt::format("{}: {} links: at most {} are supported", file.path,
                                         file.model->links_.size(), kMaxLinks));
  }
  for (const auto& [name, joint] : file.model->joints_) {
    const urdf::Vector3& p = joint->parent_to_joint_origin_transform.position;
    for (const double x : {p.x, p.y, p.z}) {
      if (std::abs(x) <= kMaxOffset) continue;  // False for NaN.
      throw std::runtime_error(fmt::format(
          "{}: joint {}: its <origin> is at {}: give finite metres", file.path, name, x));
    }
  }
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

UrdfFile read_urdf(const std::string& path, const PackageFinder& packages,
                   const xacro::Options& options) {
  UrdfFile file;
  file.path = path;
  xacro::Expansion expansion = xacro::expand(path, packages, options);
  file.xml = std::move(expansion.xml);
  file.warnings = std::move(expansion.warnings);
  repair_urdf(*file.xml->RootElement(), path, file.warnings);
  require_tree(*file.xml->RootElement(), path);
  file.model = parse(file);
  require_sound(file);
  return file;
}

}  // namespace castaway::sim
