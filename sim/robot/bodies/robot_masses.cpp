#include "sim/robot/bodies/robot_masses.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>
#include <Eigen/Eigenvalues>

#include "sim/robot/urdf/part_points.hpp"

namespace castaway::sim {
namespace {

constexpr double kMinEdge = 0.02;  // [m]

/// Inertia of a point mass at `p` about the origin.
Eigen::Matrix3d point_inertia(double mass, const Eigen::Vector3d& p) {
  return mass * (p.squaredNorm() * Eigen::Matrix3d::Identity() - p * p.transpose());
}

constexpr double kGuessedDensity = 300.0;  // [kg/m^3] Of links without mass: half-empty boxes.

/// Guesses the mass of the box around points. [kg]
double guessed_mass(const std::vector<Eigen::Vector3d>& points_base) {
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& p : points_base) box.extend(p);
  return std::clamp(kGuessedDensity * box.volume(), 0.02, 50.0);
}

Eigen::Matrix3d to_matrix(const urdf::Inertial& i) {
  Eigen::Matrix3d inertia;
  inertia << i.ixx, i.ixy, i.ixz, i.ixy, i.iyy, i.iyz, i.ixz, i.iyz, i.izz;
  return inertia;
}

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

bool possible_inertia(const Eigen::Matrix3d& inertia) {
  if (!inertia.allFinite()) return false;
  const Eigen::Vector3d moments =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(inertia, Eigen::EigenvaluesOnly).eigenvalues();
  return moments.minCoeff() > 0.0 && moments.maxCoeff() <= 1.01 * (moments[0] + moments[1]);
}

BodyMass box_mass(const std::vector<Eigen::Vector3d>& points_base, double mass) {
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& p : points_base) box.extend(p);
  if (points_base.empty()) box.extend(Eigen::Vector3d::Zero().eval());
  const Eigen::Vector3d s = box.sizes().cwiseMax(kMinEdge).cwiseAbs2();
  const Eigen::Vector3d moments(s.y() + s.z(), s.z() + s.x(), s.x() + s.y());
  return {mass, box.center(), (mass / 12.0 * moments).asDiagonal()};
}

BodyMass lump(const std::vector<BodyMass>& bodies) {
  BodyMass sum;
  for (const BodyMass& body : bodies) {
    sum.mass += body.mass;
    sum.p_base_com += body.mass * body.p_base_com;
  }
  if (sum.mass <= 0.0) return sum;
  sum.p_base_com /= sum.mass;
  for (const BodyMass& body : bodies) {
    sum.inertia += body.inertia + point_inertia(body.mass, body.p_base_com - sum.p_base_com);
  }
  return sum;
}

BodyMass link_mass(const urdf::Link& link, const LinkFrames& frames,
                   const std::vector<Eigen::Vector3d>& points_base,
                   std::vector<std::string>& warnings) {
  const Eigen::Isometry3d& T_base_link = frames.at(link.name);
  const bool has_mass =
      link.inertial && link.inertial->mass > 0.0 && std::isfinite(link.inertial->mass);
  if (has_mass && possible_inertia(to_matrix(*link.inertial))) {
    const Eigen::Isometry3d T = T_base_link * to_transform(link.inertial->origin);
    const Eigen::Matrix3d R = T.linear();
    return {link.inertial->mass, T.translation(), R * to_matrix(*link.inertial) * R.transpose()};
  }
  if (points_base.empty() && !has_mass) return {};
  const double mass = has_mass ? link.inertial->mass : guessed_mass(points_base);
  warnings.push_back(
      fmt::format("link {}: no valid inertia: using that of a box of {:.2f} kg", link.name, mass));
  BodyMass body = box_mass(points_base, mass);
  if (points_base.empty()) body.p_base_com = T_base_link.translation();
  return body;
}

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
  double mass = robot.chassis_mass;
  for (const DriveWheel& wheel : robot.wheels) mass += wheel.mass;
  return kGravity * mass / static_cast<double>(robot.wheels.size());
}

}  // namespace castaway::sim
