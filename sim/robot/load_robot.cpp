#include "sim/robot/load_robot.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>
#include <stdexcept>

#include <fmt/format.h>

#include "sim/robot/lidar_discovery.hpp"
#include "sim/robot/link_mass.hpp"
#include "sim/robot/part_points.hpp"
#include "sim/robot/supports.hpp"
#include "sim/robot/urdf_parts.hpp"
#include "sim/robot/wheel_discovery.hpp"

namespace castaway::sim {
namespace {

/// The stages of loading share these.
class RobotLoader {
 public:
  RobotLoader(const std::string& path, const std::vector<std::string>& search_paths)
      : file_(read_urdf(path)), finder_(path, search_paths), frames_(link_frames(*file_.model)) {
    robot_.name = file_.model->getName();
    robot_.path = std::filesystem::absolute(path).lexically_normal().string();
  }

  RobotModel load() {
    const std::vector<std::string> joints = find_drive_joints(file_, frames_);
    for (const std::string& joint : joints) add_wheel(*file_.model->joints_.at(joint));
    put_base_on_floor();
    measure_drive();
    collect_parts();
    add_masses();
    find_casters(robot_, swivels());
    balance(robot_);
    robot_.lidar = find_lidar(file_, frames_);
    measure_extent();
    robot_.frames = frames_;
    return std::move(robot_);
  }

 private:
  void add_wheel(const urdf::Joint& joint);
  void put_base_on_floor();
  void measure_drive();
  void collect_parts();
  void add_masses();
  [[nodiscard]] std::vector<Eigen::Vector3d> points_of(const std::string& link) const;
  [[nodiscard]] std::set<std::string> swivels() const;
  void measure_extent();
  DriveWheel* wheel_on(const std::string& link);

  UrdfFile file_;
  MeshFinder finder_;
  LinkFrames frames_;
  RobotModel robot_;
};

void RobotLoader::add_wheel(const urdf::Joint& joint) {
  const urdf::Link& link = *file_.model->links_.at(joint.child_link_name);
  DriveWheel wheel;
  wheel.joint = joint.name;
  wheel.link = link.name;
  wheel.p_base_wheel = frames_.at(link.name).translation();
  wheel.radius = wheel_radius(file_, link, frames_, finder_);
  if (joint.limits) {
    wheel.effort_max = joint.limits->effort;
    wheel.speed_max = joint.limits->velocity;
  }
  robot_.wheels.push_back(wheel);
}

/// Frame base is the root link's, moved down to where the wheels touch.
void RobotLoader::put_base_on_floor() {
  double floor = robot_.wheels.front().p_base_wheel.z();
  for (const DriveWheel& wheel : robot_.wheels) {
    floor = std::min(floor, wheel.p_base_wheel.z() - wheel.radius);
  }
  for (auto& [link, T_base_link] : frames_) T_base_link.translation().z() -= floor;
  for (DriveWheel& wheel : robot_.wheels) wheel.p_base_wheel.z() -= floor;
}

void RobotLoader::measure_drive() {
  const auto count = static_cast<double>(robot_.wheels.size());
  double left = 0.0;
  double right = 0.0;
  robot_.wheel_radius = 0.0;
  robot_.p_base_axle.setZero();
  for (std::size_t i = 0; i < robot_.wheels.size(); ++i) {
    const DriveWheel& wheel = robot_.wheels[i];
    (i % 2 == 0 ? left : right) += wheel.p_base_wheel.y() / (0.5 * count);
    robot_.wheel_radius += wheel.radius / count;
    robot_.p_base_axle += wheel.p_base_wheel.head<2>() / count;
  }
  robot_.track = left - right;
  if (robot_.wheels.size() > 2) {
    robot_.warnings.emplace_back(
        "skid-steered: turns slip, so that wheel odometry of turns is poor");
  }
}

void RobotLoader::collect_parts() {
  for (const auto& [name, link] : file_.model->links_) {
    auto collisions = collision_parts(*link, frames_, finder_, robot_.warnings);
    auto visuals = visual_parts(*link, frames_, finder_, robot_.warnings);
    if (collisions.empty() && wheel_on(name) != nullptr) collisions = visuals;
    std::move(collisions.begin(), collisions.end(), std::back_inserter(robot_.collisions));
    std::move(visuals.begin(), visuals.end(), std::back_inserter(robot_.visuals));
  }
  if (robot_.collisions.size() > robot_.wheels.size() || robot_.visuals.empty()) return;
  robot_.warnings.emplace_back("no collision shapes on the chassis: its visual shapes collide");
  for (const RobotPart& part : robot_.visuals) {
    if (wheel_on(part.link) == nullptr) robot_.collisions.push_back(part);
  }
}

DriveWheel* RobotLoader::wheel_on(const std::string& link) {
  const auto wheel = std::find_if(robot_.wheels.begin(), robot_.wheels.end(),
                                  [&link](const DriveWheel& w) { return w.link == link; });
  return wheel == robot_.wheels.end() ? nullptr : &*wheel;
}

std::vector<Eigen::Vector3d> RobotLoader::points_of(const std::string& link) const {
  std::vector<Eigen::Vector3d> points;
  for (const auto* parts : {&robot_.collisions, &robot_.visuals}) {
    for (const RobotPart& part : *parts) {
      if (part.link != link) continue;
      for (const Eigen::Vector3d& p : part_points(part)) points.push_back(p);
    }
    if (!points.empty()) break;
  }
  return points;
}

void RobotLoader::add_masses() {
  std::vector<BodyMass> chassis;
  for (const auto& [name, link] : file_.model->links_) {
    const BodyMass body = link_mass(*link, frames_, points_of(name), robot_.warnings);
    if (DriveWheel* wheel = wheel_on(name)) {
      wheel->mass = body.mass;
      wheel->inertia_spin = body.inertia(1, 1);
      wheel->inertia_tilt = 0.5 * (body.inertia(0, 0) + body.inertia(2, 2));
    } else if (body.mass > 0.0) {
      chassis.push_back(body);
    }
  }
  const BodyMass sum = lumped(chassis);
  if (sum.mass <= 0.0) {
    throw std::runtime_error(fmt::format(
        "{}: nothing but wheels: give the chassis a <collision> or an <inertial>", file_.path));
  }
  robot_.chassis_mass = sum.mass;
  robot_.p_base_com = sum.p_base_com;
  robot_.inertia = sum.inertia;
}

/// Links on joints that could move, but are not driven.
std::set<std::string> RobotLoader::swivels() const {
  std::set<std::string> links;
  for (const auto& [name, joint] : file_.model->joints_) {
    if (joint->type != urdf::Joint::FIXED) links.insert(joint->child_link_name);
  }
  return links;
}

void RobotLoader::measure_extent() {
  robot_.footprint_radius = 0.0;
  robot_.height = 0.0;
  for (const RobotPart& part : robot_.collisions) {
    for (const Eigen::Vector3d& p : part_points(part)) {
      robot_.footprint_radius = std::max(robot_.footprint_radius, p.head<2>().norm());
      robot_.height = std::max(robot_.height, p.z());
    }
  }
}

}  // namespace

RobotModel load_robot(const std::string& path, const std::vector<std::string>& search_paths) {
  return RobotLoader(path, search_paths).load();
}

}  // namespace castaway::sim
