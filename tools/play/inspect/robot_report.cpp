#include "tools/play/inspect/robot_report.hpp"

#include <iterator>
#include <numbers>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "sim/robot/robot_sensors.hpp"
#include "sim/sensor/lidar_config.hpp"

namespace castaway::testbed {
namespace {

using Lines = std::back_insert_iterator<std::string>;

double degrees(double radians) { return radians * 180.0 / std::numbers::pi; }

std::string point(const Eigen::Vector3d& p) {
  return fmt::format("({:.3f}, {:.3f}, {:.3f}) m", p.x(), p.y(), p.z());
}

/// Joins at most ten names with commas.
std::string first_of(std::vector<std::string> names) {
  constexpr std::size_t kShown = 10;
  const bool more = names.size() > kShown;
  if (more) names.resize(kShown);
  return fmt::format("{}{}", fmt::join(names, ", "), more ? ", ..." : "");
}

/// Configuration that a run would use for a lidar.
sim::LidarConfig config_of(const sim::RobotModel& robot, const sim::LidarMount& lidar) {
  sim::RobotModel alone = robot;
  alone.lidar = lidar;
  return sim::lidar_of(alone);
}

void add_body(const sim::RobotModel& robot, Lines out) {
  fmt::format_to(out, "robot: {} ({})\n", robot.name, robot.path);
  double mass = robot.chassis_mass;
  for (const sim::DriveWheel& wheel : robot.wheels) mass += wheel.mass;
  fmt::format_to(out, "mass: {:.3f} kg, of this {:.3f} kg without the wheels, centred at {}\n",
                 mass, robot.chassis_mass, point(robot.p_base_com));
  fmt::format_to(out, "size: footprint radius {:.3f} m, height {:.3f} m\n", robot.footprint_radius,
                 robot.height);
  std::vector<std::string> links;
  for (const auto& [link, T_base_link] : robot.frames) links.push_back(link);
  fmt::format_to(out, "links: {} ({})\n", links.size(), first_of(links));
  if (!robot.locked_joints.empty()) {
    fmt::format_to(out, "locked joints: {} ({})\n", robot.locked_joints.size(),
                   first_of(robot.locked_joints));
  }
  fmt::format_to(out, "shapes: {} that collide, {} to be seen\n", robot.collisions.size(),
                 robot.visuals.size());
}

/// Drive model that is simulated, and the described one that it replaces.
std::string drive_of(const sim::RobotModel& robot) {
  const char* here = robot.wheels.size() > 2 ? "skid steer" : "differential";
  return robot.other_drive.empty() ? here
                                   : fmt::format("{} in place of {}", here, robot.other_drive);
}

/// Top speed [m/s] by the limits of the wheels' joints; 0 if they have none.
double top_speed(const sim::RobotModel& robot) {
  double speed = 0.0;
  for (const sim::DriveWheel& wheel : robot.wheels) {
    const double rim = wheel.speed_max * wheel.radius;
    if (rim > 0.0 && (speed == 0.0 || rim < speed)) speed = rim;
  }
  return speed;
}

void add_drive(const sim::RobotModel& robot, Lines out) {
  fmt::format_to(out,
                 "drive: {}, {} wheels found by {}, radius {:.4f} m, track {:.4f} m, axle at "
                 "x = {:.4f} m\n",
                 drive_of(robot), robot.wheels.size(), robot.wheels_found_by, robot.wheel_radius,
                 robot.wheel_separation, robot.p_base_axle.x());
  if (robot.wheels.size() > 2) {
    fmt::format_to(out, "  turns on the spot like a differential drive of track {:.4f} m\n",
                   robot.track);
  }
  if (const double speed = top_speed(robot); speed > 0.0) {
    fmt::format_to(out, "  at most {:.2f} m/s, by <limit velocity> of the wheels' joints\n", speed);
  }
  for (const sim::DriveWheel& wheel : robot.wheels) {
    fmt::format_to(out, "  wheel {} (joint {}): at {}, radius {:.4f} m, {:.3f} kg\n", wheel.link,
                   wheel.joint, point(wheel.p_base_wheel), wheel.radius, wheel.mass);
  }
  for (const sim::Caster& caster : robot.casters) {
    fmt::format_to(out, "  caster: at {}, radius {:.4f} m\n", point(caster.p_base_caster),
                   caster.radius);
  }
}

void add_lidar(const sim::RobotModel& robot, const sim::LidarMount& mount, Lines out) {
  const sim::LidarConfig lidar = config_of(robot, mount);
  const Eigen::Vector3d x_axis = mount.T_base_laser.linear().col(0);
  const double yaw = degrees(std::atan2(x_axis.y(), x_axis.x()));
  const bool upside_down = mount.T_base_laser.linear()(2, 2) < 0.0;
  fmt::format_to(
      out,
      "lidar: link {}{}, at {}, yaw {:.1f} deg{}, {} beams of {:.3f} deg, {:.2f} to "
      "{:.2f} m, {:.1f} Hz{}\n",
      mount.link, mount.specs ? ", sensor " + mount.sensor : ", by its name",
      point(mount.T_base_laser.translation()), yaw, upside_down ? ", upside down" : "", lidar.beams,
      degrees(lidar.angle_increment), lidar.range_min, lidar.range_max, lidar.rate_hz,
      mount.specs && mount.specs->layers > 1 ? fmt::format(", {} layers", mount.specs->layers)
                                             : "");
}

nlohmann::ordered_json to_json(const Eigen::Vector3d& p) { return {p.x(), p.y(), p.z()}; }

nlohmann::ordered_json wheels_json(const sim::RobotModel& robot) {
  auto list = nlohmann::ordered_json::array();
  for (const sim::DriveWheel& wheel : robot.wheels) {
    list.push_back({{"link", wheel.link},
                    {"joint", wheel.joint},
                    {"position_m", to_json(wheel.p_base_wheel)},
                    {"radius_m", wheel.radius},
                    {"mass_kg", wheel.mass}});
  }
  return list;
}

nlohmann::ordered_json lidars_json(const sim::RobotModel& robot) {
  auto list = nlohmann::ordered_json::array();
  for (const sim::LidarMount& mount : robot.lidars) {
    const sim::LidarConfig lidar = config_of(robot, mount);
    list.push_back({{"link", mount.link},
                    {"sensor", mount.sensor},
                    {"position_m", to_json(mount.T_base_laser.translation())},
                    {"beams", lidar.beams},
                    {"angle_min_rad", lidar.angle_min},
                    {"angle_increment_rad", lidar.angle_increment},
                    {"range_min_m", lidar.range_min},
                    {"range_max_m", lidar.range_max},
                    {"rate_hz", lidar.rate_hz},
                    {"layers", mount.specs ? mount.specs->layers : 1}});
  }
  return list;
}

nlohmann::ordered_json casters_json(const sim::RobotModel& robot) {
  auto list = nlohmann::ordered_json::array();
  for (const sim::Caster& caster : robot.casters) {
    list.push_back({{"position_m", to_json(caster.p_base_caster)}, {"radius_m", caster.radius}});
  }
  return list;
}

}  // namespace

std::string robot_text(const sim::RobotModel& robot) {
  std::string text;
  const Lines out(text);
  add_body(robot, out);
  add_drive(robot, out);
  for (const sim::LidarMount& lidar : robot.lidars) add_lidar(robot, lidar, out);
  if (robot.lidars.empty()) {
    text += fmt::format("lidar: none found; runs use one free of the body at {}\n",
                        point(sim::lidar_of(robot).T_base_laser.translation()));
  }
  if (robot.lidars.size() > 1) {
    text += fmt::format("  runs use all {} lidars; `lidars` in a scenario chooses among them\n",
                        robot.lidars.size());
  }
  for (const std::string& warning : robot.warnings) text += "warning: " + warning + "\n";
  return text;
}

nlohmann::ordered_json robot_json(const sim::RobotModel& robot) {
  nlohmann::ordered_json json{{"name", robot.name}, {"file", robot.path}};
  auto links = nlohmann::ordered_json::array();
  for (const auto& [link, T_base_link] : robot.frames) links.push_back(link);
  json["links"] = links;
  json["locked_joints"] = robot.locked_joints;
  json["chassis"] = {{"mass_kg", robot.chassis_mass},
                     {"centre_of_mass_m", to_json(robot.p_base_com)},
                     {"collision_shapes", robot.collisions.size()},
                     {"visual_shapes", robot.visuals.size()}};
  json["footprint_radius_m"] = robot.footprint_radius;
  json["height_m"] = robot.height;
  json["drive"] = {{"kind", robot.wheels.size() > 2 ? "skid steer" : "differential"},
                   {"in_place_of", robot.other_drive},
                   {"top_speed_m_s", top_speed(robot)},
                   {"found_by", robot.wheels_found_by},
                   {"wheel_radius_m", robot.wheel_radius},
                   {"track_m", robot.wheel_separation},
                   {"effective_track_m", robot.track},
                   {"axle_x_m", robot.p_base_axle.x()}};
  json["wheels"] = wheels_json(robot);
  json["casters"] = casters_json(robot);
  json["lidars"] = lidars_json(robot);
  json["warnings"] = robot.warnings;
  return json;
}

}  // namespace castaway::testbed
