#include "sim/robot/load_robot.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>
#include <stdexcept>

#include <fmt/format.h>

#include "sim/robot/bodies/robot_masses.hpp"
#include "sim/robot/bodies/skid_steer.hpp"
#include "sim/robot/discovery/drive_kind.hpp"
#include "sim/robot/discovery/lidar_discovery.hpp"
#include "sim/robot/discovery/mount_wheels.hpp"
#include "sim/robot/discovery/supports.hpp"
#include "sim/robot/discovery/wheel_discovery.hpp"
#include "sim/robot/urdf/part_points.hpp"
#include "sim/robot/urdf/urdf_parts.hpp"
#include "xacro/expand.hpp"
#include "xacro/files/xml_text.hpp"

namespace castaway::sim {
namespace {

constexpr double kSameSize = 0.02;  // Relative difference below which two sizes are the same.

/// The search paths, those of the environment last.
std::vector<std::string> all_search_paths(const RobotOptions& options) {
  std::vector<std::string> paths = options.search_paths;
  for (const std::string& path : package_paths_of_environment()) paths.push_back(path);
  return paths;
}

/// Removes repeated warnings: a mesh may be a visual and a collision shape.
void drop_repetitions(std::vector<std::string>& warnings) {
  std::set<std::string> seen;
  std::erase_if(warnings, [&](const std::string& text) { return !seen.insert(text).second; });
}

/// The state that the stages of loading share.
class RobotLoader {
 public:
  RobotLoader(const std::string& path, const RobotOptions& options)
      : packages_(path, all_search_paths(options)),
        finder_(packages_),
        file_(read_urdf(path, packages_, options)),
        tags_(find_drive_tags(file_, packages_, options)),
        frames_(link_frames(*file_.model,
                            joint_positions(*file_.model, options.joints, file_.warnings))) {
    robot_.name = file_.model->getName();
    robot_.path = std::filesystem::absolute(path).lexically_normal().string();
    robot_.warnings = file_.warnings;
  }

  RobotModel load() {
    const DriveJoints drive = find_drive_joints(file_, frames_, finder_, tags_, robot_.warnings);
    robot_.wheels_found_by = drive.found_by;
    robot_.wheels = mount_wheels(file_, frames_, finder_, tags_, drive, robot_.warnings);
    name_drive();
    put_base_on_floor();
    measure_drive();
    collect_parts();
    add_masses(file_, frames_, robot_);
    lock_joints();
    find_casters(robot_, swivels());
    balance(robot_);
    robot_.lidars = find_lidars(file_, frames_, robot_.warnings);
    if (!robot_.lidars.empty()) robot_.lidar = robot_.lidars.front();
    measure_extent();
    if (robot_.wheels.size() > 2) steer_by_skidding(robot_);
    note_drive();
    robot_.frames = frames_;
    drop_repetitions(robot_.warnings);
    return std::move(robot_);
  }

 private:
  void name_drive();
  void note_drive();
  void compare_separation();
  void lock_joints();
  void put_base_on_floor();
  void measure_drive();
  void collect_parts();
  [[nodiscard]] std::set<std::string> swivels() const;
  void measure_extent();
  DriveWheel* wheel_on(const std::string& link);

  PackageFinder packages_;
  MeshFinder finder_;
  UrdfFile file_;
  DriveTags tags_;
  LinkFrames frames_;
  RobotModel robot_;
};

/// Sets how the robot moves if not as simulated.
void RobotLoader::name_drive() {
  const auto drive = other_drive(file_, frames_, robot_.wheels, tags_.controllers);
  if (!drive) return;
  robot_.other_drive = describe(*drive);
  robot_.drive_note = other_drive_warning(*drive, robot_.wheels.size());
  robot_.warnings.push_back(robot_.drive_note);
  robot_.drive_note = "the robot " + robot_.drive_note;
}

/// Says how a skid steer turns; what replaces another drive has been said.
void RobotLoader::note_drive() {
  if (robot_.wheels.size() <= 2 || !robot_.drive_note.empty()) return;
  robot_.drive_note = fmt::format(
      "the robot is a skid steer: its wheels slide as on dry, even ground, so that it turns like a "
      "differential drive of track {:.3f} m, though they are {:.3f} m apart",
      robot_.track, robot_.wheel_separation);
}

void RobotLoader::compare_separation() {
  if (!tags_.separation) return;
  if (std::abs(*tags_.separation / robot_.wheel_separation - 1.0) < kSameSize) return;
  robot_.warnings.push_back(fmt::format(
      "the wheels are {:.4f} m apart, the {} tag says {:.4f} m: the wheels' distance is used",
      robot_.wheel_separation, tags_.dialect, *tags_.separation));
}

/// Lists joints that could move but are not driven.
void RobotLoader::lock_joints() {
  for (const auto& [name, joint] : file_.model->joints_) {
    const bool driven = wheel_on(joint->child_link_name) != nullptr;
    if (joint->type != urdf::Joint::FIXED && !driven) robot_.locked_joints.push_back(name);
  }
}

/// Moves frame base from the root link down to where the wheels touch the floor.
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
  robot_.wheel_separation = robot_.track = left - right;
  compare_separation();
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
  robot_.warnings.emplace_back("the chassis has no collision shapes: its visual shapes are used");
  for (const RobotPart& part : robot_.visuals) {
    if (wheel_on(part.link) == nullptr) robot_.collisions.push_back(part);
  }
}

DriveWheel* RobotLoader::wheel_on(const std::string& link) {
  const auto wheel = std::find_if(robot_.wheels.begin(), robot_.wheels.end(),
                                  [&link](const DriveWheel& w) { return w.link == link; });
  return wheel == robot_.wheels.end() ? nullptr : &*wheel;
}

/// Links on locked joints.
std::set<std::string> RobotLoader::swivels() const {
  std::set<std::string> links;
  for (const std::string& name : robot_.locked_joints) {
    links.insert(file_.model->joints_.at(name)->child_link_name);
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

/// Adds the robot's file name to errors that lack it.
template <typename Work>
auto naming_file(const std::string& path, Work work) {
  try {
    return work();
  } catch (const std::exception& error) {
    const std::string what = error.what();
    if (what.find(std::filesystem::path(path).filename().string()) != std::string::npos) throw;
    throw std::runtime_error(fmt::format("{}: {}", path, what));
  }
}

}  // namespace

RobotModel load_robot(const std::string& path, const RobotOptions& options) {
  return naming_file(path, [&] { return RobotLoader(path, options).load(); });
}

ExpandedRobot expand_robot(const std::string& path, const RobotOptions& options) {
  return naming_file(path, [&] {
    const PackageFinder packages(path, all_search_paths(options));
    xacro::Expansion expansion = xacro::expand(path, packages, options);
    return ExpandedRobot{xml_text_of(*expansion.xml), std::move(expansion.warnings)};
  });
}

}  // namespace castaway::sim
