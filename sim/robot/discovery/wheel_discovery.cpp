#include "sim/robot/discovery/wheel_discovery.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "xacro/files/lower_case.hpp"

namespace castaway::sim {
namespace {

constexpr double kMirrorTolerance = 0.02;  // [m]
constexpr double kAxisTolerance = 0.02;    // Of the cosine of the angle to an axis.
constexpr double kMinTrack = 0.04;         // [m]
constexpr double kFloorTolerance = 0.03;   // [m]
constexpr std::size_t kMostPairs = 10;

/// A joint that could carry a wheel.
struct WheelCandidate {
  std::string joint;
  Eigen::Vector3d p_root = Eigen::Vector3d::Zero();
  double low = 0.0;  ///< [m] Lowest point of its wheel in the root link's frame.
};

/// Wheels opposite each other.
struct Pair {
  WheelCandidate left;
  WheelCandidate right;
};

/// Kinds of joints that may lie between a wheel and the chassis.
enum class Hang { kFixed, kSuspension, kAny };

bool allows(Hang hang, const urdf::Joint& joint) {
  if (joint.type == urdf::Joint::FIXED || hang == Hang::kAny) return true;
  const bool bounded = joint.type == urdf::Joint::PRISMATIC || joint.type == urdf::Joint::REVOLUTE;
  return hang == Hang::kSuspension && bounded;
}

bool hangs(const urdf::ModelInterface& model, const urdf::Joint& joint, Hang hang) {
  for (auto link = model.getLink(joint.parent_link_name); link->parent_joint;
       link = model.getLink(link->parent_joint->parent_link_name)) {
    if (!allows(hang, *link->parent_joint)) return false;
  }
  return true;
}

bool turns_about_y(const urdf::Joint& joint, const LinkFrames& frames) {
  const Eigen::Vector3d axis(joint.axis.x, joint.axis.y, joint.axis.z);
  const Eigen::Vector3d in_root = frames.at(joint.child_link_name).linear() * axis.normalized();
  return std::abs(in_root.y()) > 1.0 - kAxisTolerance;
}

bool is_passive(const std::string& name) {
  return holds_word(name, {"caster", "castor", "passive", "idler"});
}

/// Collects the candidates of one robot.
class Gatherer {
 public:
  Gatherer(const UrdfFile& file, const LinkFrames& frames, const MeshFinder& finder)
      : model_(*file.model), frames_(frames), finder_(finder) {}

  /// Candidates that a plug-in names as the wheels it drives.
  [[nodiscard]] std::vector<WheelCandidate> among(const std::set<std::string>& names) const {
    std::vector<WheelCandidate> result;
    for (const std::string& name : names) {
      const auto joint = model_.joints_.find(name);
      if (joint != model_.joints_.end() && joint->second->type != urdf::Joint::FIXED &&
          turns_about_y(*joint->second, frames_)) {
        result.push_back(candidate(*joint->second));
      }
    }
    return result;
  }

  /// Candidates among commanded joints: a motor's tag alone does not make a wheel. Excludes
  /// casters, and joints below something that turns freely.
  [[nodiscard]] std::vector<WheelCandidate> driving_among(
      const std::set<std::string>& names) const {
    std::set<std::string> driving;
    for (const std::string& name : names) {
      const auto joint = model_.joints_.find(name);
      if (joint == model_.joints_.end() || is_passive(name)) continue;
      const bool passive =
          is_passive(joint->second->child_link_name) || is_passive(joint->second->parent_link_name);
      if (!passive && hangs(model_, *joint->second, Hang::kSuspension)) driving.insert(name);
    }
    return among(driving);
  }

  [[nodiscard]] std::vector<WheelCandidate> hanging(Hang hang) const {
    std::vector<WheelCandidate> result;
    for (const auto& [name, joint] : model_.joints_) {
      const bool wheel = joint->type == urdf::Joint::CONTINUOUS && !joint->mimic &&
                         !is_passive(name) && !is_passive(joint->child_link_name);
      if (wheel && hangs(model_, *joint, hang) && turns_about_y(*joint, frames_)) {
        result.push_back(candidate(*joint));
      }
    }
    return result;
  }

 private:
  [[nodiscard]] WheelCandidate candidate(const urdf::Joint& joint) const {
    const urdf::Link& link = *model_.links_.at(joint.child_link_name);
    const Eigen::Vector3d p = frames_.at(link.name).translation();
    const auto shape = wheel_shape(link, frames_, finder_);
    return {joint.name, p, p.z() - (shape ? shape->radius : 0.0)};
  }

  const urdf::ModelInterface& model_;
  const LinkFrames& frames_;
  const MeshFinder& finder_;
};

bool beside(const WheelCandidate& left, const WheelCandidate& right) {
  return left.p_root.y() - right.p_root.y() > kMinTrack &&
         std::abs(left.p_root.x() - right.p_root.x()) < kMirrorTolerance &&
         std::abs(left.p_root.z() - right.p_root.z()) < kMirrorTolerance;
}

/// Pairs the joints, outermost first, each in at most one pair. The front pair comes first.
std::vector<Pair> pairs_of(std::vector<WheelCandidate> joints) {
  std::sort(joints.begin(), joints.end(), [](const WheelCandidate& a, const WheelCandidate& b) {
    return a.p_root.y() != b.p_root.y() ? a.p_root.y() > b.p_root.y() : a.joint < b.joint;
  });
  std::vector<Pair> pairs;
  std::set<std::string> taken;
  for (const WheelCandidate& left : joints) {
    if (taken.contains(left.joint)) continue;
    const auto right = std::find_if(joints.rbegin(), joints.rend(), [&](const WheelCandidate& c) {
      return !taken.contains(c.joint) && beside(left, c);
    });
    if (right == joints.rend()) continue;
    taken.insert({left.joint, right->joint});
    pairs.push_back({left, *right});
  }
  std::stable_sort(pairs.begin(), pairs.end(), [](const Pair& a, const Pair& b) {
    return a.left.p_root.x() > b.left.p_root.x();
  });
  return pairs;
}

/// Removes pairs whose wheels are higher above the floor than the lowest pair's.
std::vector<Pair> on_floor(std::vector<Pair> pairs) {
  double floor = 1e9;
  for (const Pair& pair : pairs) floor = std::min(floor, pair.left.low);
  std::erase_if(pairs, [floor](const Pair& p) { return p.left.low > floor + kFloorTolerance; });
  return pairs;
}

std::vector<Pair> named_pairs(const Gatherer& gatherer, const DriveTags& tags) {
  std::set<std::string> names(tags.left.begin(), tags.left.end());
  names.insert(tags.right.begin(), tags.right.end());
  if (!names.empty()) return on_floor(pairs_of(gatherer.among(names)));
  names.insert(tags.driven.begin(), tags.driven.end());
  return on_floor(pairs_of(gatherer.driving_among(names)));
}

/// The joint between a wheel and the root that keeps it from being a drive wheel.
const urdf::Joint& turning_base(const urdf::ModelInterface& model, const std::string& wheel) {
  auto joint = model.joints_.at(wheel);
  for (auto link = model.getLink(joint->parent_link_name); link->parent_joint;
       link = model.getLink(link->parent_joint->parent_link_name)) {
    joint = link->parent_joint;
    if (!allows(Hang::kSuspension, *joint)) break;
  }
  return *joint;
}

const char* type_name(const urdf::Joint& joint) {
  switch (joint.type) {
    case urdf::Joint::CONTINUOUS:
      return "continuous";
    case urdf::Joint::FLOATING:
      return "floating";
    case urdf::Joint::PLANAR:
      return "planar";
    default:
      return "movable";
  }
}

/// Refuses wheels that hang below something that moves freely.
void refuse_turning_base(const UrdfFile& file, const Gatherer& gatherer) {
  const std::vector<Pair> pairs = on_floor(pairs_of(gatherer.hanging(Hang::kAny)));
  if (pairs.empty()) return;
  const Pair& pair = pairs.front();
  const urdf::Joint& base = turning_base(*file.model, pair.left.joint);
  throw std::runtime_error(fmt::format(
      "{}: the wheels of {} and {} hang below joint '{}' of type {}, which moves freely: drive "
      "wheels are on the chassis or on a suspension; make this joint fixed",
      file.path, pair.left.joint, pair.right.joint, base.name, type_name(base)));
}

[[noreturn]] void no_wheels(const UrdfFile& file, const Gatherer& gatherer) {
  refuse_turning_base(file, gatherer);
  std::vector<std::string> found;
  for (const WheelCandidate& c : gatherer.hanging(Hang::kAny)) found.push_back(c.joint);
  throw std::runtime_error(fmt::format(
      "{}: no drive wheels: needs two joints of type continuous with their axes along y, left and "
      "right of each other; found [{}]: check <joint type> and <axis>",
      file.path, fmt::join(found, ", ")));
}

}  // namespace

DriveJoints find_drive_joints(const UrdfFile& file, const LinkFrames& frames,
                              const MeshFinder& finder, const DriveTags& tags,
                              std::vector<std::string>& warnings) {
  const Gatherer gatherer(file, frames, finder);
  DriveJoints result;
  result.found_by = tags.dialect;
  std::vector<Pair> pairs = named_pairs(gatherer, tags);
  if (pairs.empty()) {
    result.found_by = "kinematics";
    for (const Hang hang : {Hang::kFixed, Hang::kSuspension}) {
      if (pairs.empty()) pairs = on_floor(pairs_of(gatherer.hanging(hang)));
    }
    if (pairs.empty()) no_wheels(file, gatherer);
    if (!tags.dialect.empty()) {
      warnings.push_back(fmt::format(
          "the {} tag names no pair of wheels of this robot: found by kinematics", tags.dialect));
    }
  }
  if (pairs.size() > kMostPairs) {
    throw std::runtime_error(fmt::format("{}: {} driven wheels: at most {} are supported",
                                         file.path, 2 * pairs.size(), 2 * kMostPairs));
  }
  for (const Pair& pair : pairs) {
    result.joints.push_back(pair.left.joint);
    result.joints.push_back(pair.right.joint);
  }
  return result;
}

}  // namespace castaway::sim
