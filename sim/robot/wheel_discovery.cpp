#include "sim/robot/wheel_discovery.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "sim/robot/part_points.hpp"

namespace castaway::sim {
namespace {

constexpr double kMirrorTolerance = 0.02;  // [m]
constexpr double kAxisTolerance = 0.02;    // Of the cosine.
constexpr double kMinHalfTrack = 0.02;     // [m]

/// A joint that could carry a wheel.
struct Candidate {
  std::string joint;
  Eigen::Vector3d p_root = Eigen::Vector3d::Zero();
};

/// Left and right.
struct Pair {
  Candidate left;
  Candidate right;
};

bool moves(const urdf::Joint& joint) { return joint.type != urdf::Joint::FIXED; }

/// True if all joints from the root down to the joint's parent link are fixed.
bool on_chassis(const urdf::ModelInterface& model, const urdf::Joint& joint) {
  for (auto link = model.getLink(joint.parent_link_name); link->parent_joint;
       link = model.getLink(link->parent_joint->parent_link_name)) {
    if (moves(*link->parent_joint)) return false;
  }
  return true;
}

bool turns_about_y(const urdf::Joint& joint, const LinkFrames& frames) {
  const Eigen::Vector3d axis(joint.axis.x, joint.axis.y, joint.axis.z);
  const Eigen::Vector3d in_root = frames.at(joint.child_link_name).linear() * axis.normalized();
  return std::abs(in_root.y()) > 1.0 - kAxisTolerance;
}

std::vector<Candidate> candidates(const urdf::ModelInterface& model, const LinkFrames& frames) {
  std::vector<Candidate> result;
  for (const auto& [name, joint] : model.joints_) {
    if (joint->type != urdf::Joint::CONTINUOUS || joint->mimic) continue;
    if (!on_chassis(model, *joint) || !turns_about_y(*joint, frames)) continue;
    result.push_back({name, frames.at(joint->child_link_name).translation()});
  }
  return result;
}

bool mirrored(const Candidate& left, const Candidate& right) {
  return left.p_root.y() > kMinHalfTrack &&
         std::abs(left.p_root.x() - right.p_root.x()) < kMirrorTolerance &&
         std::abs(left.p_root.z() - right.p_root.z()) < kMirrorTolerance &&
         std::abs(left.p_root.y() + right.p_root.y()) < kMirrorTolerance;
}

std::vector<Pair> mirrored_pairs(const std::vector<Candidate>& joints) {
  std::vector<Pair> pairs;
  for (const Candidate& left : joints) {
    for (const Candidate& right : joints) {
      if (mirrored(left, right)) pairs.push_back({left, right});
    }
  }
  return pairs;
}

/// Texts of all elements below gazebo and ros2_control tags, and their joint attributes: drive
/// plug-ins name their wheel joints there, each in its own dialect.
void collect_texts(const TiXmlElement& element, std::set<std::string>& texts) {
  if (element.GetText() != nullptr) texts.insert(element.GetText());
  if (element.Attribute("name") != nullptr) texts.insert(element.Attribute("name"));
  for (auto* e = element.FirstChildElement(); e != nullptr; e = e->NextSiblingElement()) {
    collect_texts(*e, texts);
  }
}

std::set<std::string> plugin_texts(const TiXmlElement& root) {
  std::set<std::string> texts;
  for (const char* tag : {"gazebo", "ros2_control", "transmission"}) {
    for (auto* e = root.FirstChildElement(tag); e != nullptr; e = e->NextSiblingElement(tag)) {
      collect_texts(*e, texts);
    }
  }
  return texts;
}

/// The pairs that plug-ins name; all of them if none is named.
std::vector<Pair> named_pairs(const std::vector<Pair>& pairs, const TiXmlElement& root) {
  const std::set<std::string> texts = plugin_texts(root);
  std::vector<Pair> named;
  for (const Pair& pair : pairs) {
    if (texts.contains(pair.left.joint) && texts.contains(pair.right.joint)) named.push_back(pair);
  }
  return named.empty() ? pairs : named;
}

/// Radius of a shape about a wheel's centre.
double radius_of(const RobotPart& part, const Eigen::Vector3d& center) {
  if (const auto* sphere = std::get_if<SphereShape>(&part.shape)) return sphere->radius;
  if (const auto* cylinder = std::get_if<CylinderShape>(&part.shape)) return cylinder->radius;
  double radius = 0.0;
  for (const Eigen::Vector3d& p : part_points(part)) {
    radius = std::max(radius, std::abs(p.z() - center.z()));
  }
  return radius;
}

double largest_radius(const std::vector<RobotPart>& parts, const Eigen::Vector3d& center) {
  double radius = 0.0;
  for (const RobotPart& part : parts) radius = std::max(radius, radius_of(part, center));
  return radius;
}

}  // namespace

std::vector<std::string> find_drive_joints(const UrdfFile& file, const LinkFrames& frames) {
  const std::vector<Candidate> joints = candidates(*file.model, frames);
  const std::vector<Pair> pairs = mirrored_pairs(joints);
  if (pairs.empty()) {
    std::vector<std::string> found;
    found.reserve(joints.size());
    for (const Candidate& c : joints) found.push_back(c.joint);
    throw std::runtime_error(fmt::format(
        "{}: no drive wheels: needs two joints of type continuous with their axes along y, "
        "mirrored left and right; found [{}]: check <joint type> and <axis>",
        file.path, fmt::join(found, ", ")));
  }
  std::vector<std::string> result;
  for (const Pair& pair : named_pairs(pairs, *file.xml->RootElement())) {
    result.push_back(pair.left.joint);
    result.push_back(pair.right.joint);
  }
  return result;
}

double wheel_radius(const UrdfFile& file, const urdf::Link& link, const LinkFrames& frames,
                    const MeshFinder& finder) {
  std::vector<std::string> ignored;  // The same warnings come with the parts.
  const Eigen::Vector3d center = frames.at(link.name).translation();
  double radius = largest_radius(collision_parts(link, frames, finder, ignored), center);
  if (radius > 0.0) return radius;
  radius = largest_radius(visual_parts(link, frames, finder, ignored), center);
  if (radius > 0.0) return radius;
  throw std::runtime_error(fmt::format(
      "{}: link {} is a drive wheel without a shape: give it a <collision> so that its radius is "
      "known",
      file.path, link.name));
}

}  // namespace castaway::sim
