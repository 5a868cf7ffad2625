#include "sim/robot/urdf/joint_positions.hpp"

#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include "xacro/files/nearest_name.hpp"

namespace castaway::sim {
namespace {

constexpr double kFarthestJoint = 1000.0;  // [m], [rad]

bool has_position(const urdf::Joint& joint) {
  return joint.type == urdf::Joint::REVOLUTE || joint.type == urdf::Joint::CONTINUOUS ||
         joint.type == urdf::Joint::PRISMATIC;
}

void require_settable(const urdf::ModelInterface& model, const std::string& name, double position) {
  const auto found = model.joints_.find(name);
  if (found == model.joints_.end()) {
    std::vector<std::string> known;
    for (const auto& [other, joint] : model.joints_) {
      if (has_position(*joint)) known.push_back(other);
    }
    throw std::runtime_error(
        fmt::format("joints: no joint '{}'; {}", name, name_hint(name, known)));
  }
  if (!has_position(*found->second)) {
    throw std::runtime_error(fmt::format("joints: '{}' is fixed: it has no position", name));
  }
  if (found->second->mimic) {
    throw std::runtime_error(fmt::format("joints: '{}' follows '{}': set that one", name,
                                         found->second->mimic->joint_name));
  }
  if (std::abs(position) <= kFarthestJoint) return;
  throw std::runtime_error(
      fmt::format("joints: {} is {}: give radians, or metres", name, position));
}

void warn_beyond_limits(const urdf::Joint& joint, double position,
                        std::vector<std::string>& warnings) {
  if (joint.type == urdf::Joint::CONTINUOUS || !joint.limits) return;
  const double low = joint.limits->lower;
  const double high = joint.limits->upper;
  if (!(low < high) || (position >= low && position <= high)) return;
  warnings.push_back(fmt::format("joints: {} is set to {}, beyond its limits of {} to {}",
                                 joint.name, position, low, high));
}

}  // namespace

JointPositions joint_positions(const urdf::ModelInterface& model, const JointPositions& asked,
                               std::vector<std::string>& warnings) {
  JointPositions positions = asked;
  for (const auto& [name, position] : asked) {
    require_settable(model, name, position);
    warn_beyond_limits(*model.joints_.at(name), position, warnings);
  }
  for (const auto& [name, joint] : model.joints_) {
    if (!joint->mimic) continue;
    const auto leader = asked.find(joint->mimic->joint_name);
    if (leader == asked.end()) continue;
    positions[name] = joint->mimic->multiplier * leader->second + joint->mimic->offset;
  }
  return positions;
}

Eigen::Isometry3d joint_motion(const urdf::Joint& joint, double position) {
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  const Eigen::Vector3d axis(joint.axis.x, joint.axis.y, joint.axis.z);
  if (position == 0.0 || !has_position(joint) || !(axis.norm() > 0.0)) return T;
  if (joint.type == urdf::Joint::PRISMATIC) {
    T.translation() = position * axis.normalized();
  } else {
    T.linear() = Eigen::AngleAxisd(position, axis.normalized()).toRotationMatrix();
  }
  return T;
}

}  // namespace castaway::sim
