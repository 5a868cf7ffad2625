#include "sim/robot/discovery/mount_wheels.hpp"

#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

namespace castaway::sim {
namespace {

constexpr double kSameMount = 0.02;    // Relative difference below which two sizes are the same.
constexpr double kRoughRadius = 0.25;  // Relative error of a radius measured on a mesh.

double radius_of(const WheelShape& shape, const std::string& link, const DriveTags& tags,
                 std::vector<std::string>& warnings) {
  if (!tags.radius) return shape.radius;
  const double difference = std::abs(*tags.radius / shape.radius - 1.0);
  if (!shape.exact && difference < kRoughRadius) return *tags.radius;
  if (difference > kSameMount) {
    warnings.push_back(
        fmt::format("link {}: its shape has a radius of {:.4f} m, the {} tag says {:.4f} m: the "
                    "shape's radius is used",
                    link, shape.radius, tags.dialect, *tags.radius));
  }
  return shape.radius;
}

}  // namespace

std::vector<DriveWheel> mount_wheels(const UrdfFile& file, const LinkFrames& frames,
                                     const MeshFinder& finder, const DriveTags& tags,
                                     const DriveJoints& drive, std::vector<std::string>& warnings) {
  std::vector<DriveWheel> wheels;
  for (const std::string& name : drive.joints) {
    const urdf::Joint& joint = *file.model->joints_.at(name);
    const urdf::Link& link = *file.model->links_.at(joint.child_link_name);
    const auto shape = wheel_shape(link, frames, finder);
    if (!shape && !tags.radius) {
      throw std::runtime_error(
          fmt::format("{}: link {} is a drive wheel without a shape: give it a <collision> so that "
                      "its radius is known",
                      file.path, link.name));
    }
    DriveWheel wheel;
    wheel.joint = name;
    wheel.link = link.name;
    wheel.p_base_wheel = frames.at(link.name).translation();
    wheel.p_base_wheel.y() += shape && shape->exact ? shape->shift : 0.0;
    wheel.radius = shape ? radius_of(*shape, link.name, tags, warnings) : *tags.radius;
    wheel.effort_max = joint.limits ? joint.limits->effort : 0.0;
    wheel.speed_max = joint.limits ? joint.limits->velocity : 0.0;
    wheels.push_back(wheel);
  }
  return wheels;
}

}  // namespace castaway::sim
