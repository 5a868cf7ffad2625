#include "sim/robot/bodies/robot_masses.hpp"

#include <algorithm>
#include <stdexcept>

#include <fmt/format.h>

#include "sim/robot/bodies/link_mass.hpp"
#include "sim/robot/urdf/part_points.hpp"

namespace castaway::sim {
namespace {

/// Points of a link's collision shapes, or of its visual shapes if it has none. [m] In base.
std::vector<Eigen::Vector3d> points_of(const RobotModel& robot, const std::string& link) {
  std::vector<Eigen::Vector3d> points;
  for (const auto* parts : {&robot.collisions, &robot.visuals}) {
    for (const RobotPart& part : *parts) {
      if (part.link != link) continue;
      for (const Eigen::Vector3d& p : part_points(part)) points.push_back(p);
    }
    if (!points.empty()) break;
  }
  return points;
}

/// Sets the wheels' masses and returns their sum. [kg]
double weigh_wheels(const UrdfFile& file, const LinkFrames& frames, RobotModel& robot) {
  double sum = 0.0;
  for (DriveWheel& wheel : robot.wheels) {
    const urdf::Link& link = *file.model->links_.at(wheel.link);
    const BodyMass body = link_mass(link, frames, points_of(robot, wheel.link), robot.warnings);
    wheel.mass = body.mass;
    wheel.inertia_spin = body.inertia(1, 1);
    wheel.inertia_tilt = 0.5 * (body.inertia(0, 0) + body.inertia(2, 2));
    sum += wheel.mass;
  }
  return sum;
}

/// Mass of all links except the wheels; links without <inertial> count only with `guess`.
BodyMass weigh_chassis(const UrdfFile& file, const LinkFrames& frames, bool guess,
                       RobotModel& robot) {
  std::vector<BodyMass> bodies;
  for (const auto& [name, link] : file.model->links_) {
    const bool wheel =
        std::any_of(robot.wheels.begin(), robot.wheels.end(),
                    [&own = link->name](const DriveWheel& w) { return w.link == own; });
    if (wheel || (!guess && !link->inertial)) continue;
    const BodyMass body = link_mass(*link, frames, points_of(robot, name), robot.warnings);
    if (body.mass > 0.0) bodies.push_back(body);
  }
  return lump(bodies);
}

}  // namespace

void add_masses(const UrdfFile& file, const LinkFrames& frames, RobotModel& robot) {
  const double wheels = weigh_wheels(file, frames, robot);
  const std::size_t warned = robot.warnings.size();
  BodyMass chassis = weigh_chassis(file, frames, false, robot);
  if (chassis.mass < wheels) {
    robot.warnings.resize(warned);
    chassis = weigh_chassis(file, frames, true, robot);
  }
  if (chassis.mass <= 0.0) {
    throw std::runtime_error(fmt::format(
        "{}: there are only wheels: give the chassis a <collision> or an <inertial>", file.path));
  }
  robot.chassis_mass = chassis.mass;
  robot.p_base_com = chassis.p_base_com;
  robot.inertia = chassis.inertia;
}

double wheel_load(const RobotModel& robot) {
  constexpr double kGravity = 9.81;  // [m/s^2]
  double mass = robot.chassis_mass;
  for (const DriveWheel& wheel : robot.wheels) mass += wheel.mass;
  return kGravity * mass / static_cast<double>(robot.wheels.size());
}

}  // namespace castaway::sim
