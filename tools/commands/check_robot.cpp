// castaway check-robot: what was understood of a robot's description.
#include <memory>
#include <numbers>

#include <fmt/format.h>

#include "sim/robot/load_robot.hpp"
#include "sim/sensor/lidar_config.hpp"
#include "tools/commands/commands.hpp"
#include "tools/scenario/data_paths.hpp"

namespace castaway::testbed {
namespace {

void print_drive(const sim::RobotModel& robot) {
  fmt::print("drive: {} wheels, radius {:.4f} m, track {:.4f} m, axle at x = {:.4f} m of base\n",
             robot.wheels.size(), robot.wheel_radius, robot.track, robot.p_base_axle.x());
  for (const sim::DriveWheel& wheel : robot.wheels) {
    fmt::print("  wheel {} (joint {}): at ({:.3f}, {:.3f}, {:.3f}) m, {:.3f} kg\n", wheel.link,
               wheel.joint, wheel.p_base_wheel.x(), wheel.p_base_wheel.y(), wheel.p_base_wheel.z(),
               wheel.mass);
  }
  for (const sim::Caster& caster : robot.casters) {
    fmt::print("  caster at ({:.3f}, {:.3f}) m, radius {:.4f} m\n", caster.p_base_caster.x(),
               caster.p_base_caster.y(), caster.radius);
  }
}

void print_lidar(const sim::RobotModel& robot) {
  if (!robot.lidar) {
    fmt::print("lidar: none found; runs use one 0.2 m above base\n");
    return;
  }
  const sim::LidarConfig lidar = sim::lidar_of(robot);
  const Eigen::Vector3d p = lidar.T_base_laser.translation();
  fmt::print(
      "lidar: link {}, at ({:.3f}, {:.3f}, {:.3f}) m, {} beams of {:.3f} deg, {:.2f} to {:.2f} m, "
      "{:.1f} Hz\n",
      robot.lidar->link, p.x(), p.y(), p.z(), lidar.beams,
      lidar.angle_increment * 180.0 / std::numbers::pi, lidar.range_min, lidar.range_max,
      lidar.rate_hz);
}

int check_robot(const std::string& text) {
  const sim::RobotModel robot = sim::load_robot(find_robot(text, ".").string());
  fmt::print("robot: {} ({})\n", robot.name, robot.path);
  fmt::print(
      "body: {:.3f} kg, centre of mass ({:.3f}, {:.3f}, {:.3f}) m, footprint radius {:.3f} m, "
      "height {:.3f} m\n",
      robot.chassis_mass, robot.p_base_com.x(), robot.p_base_com.y(), robot.p_base_com.z(),
      robot.footprint_radius, robot.height);
  fmt::print("links: {}, collision shapes: {}, visual shapes: {}\n", robot.frames.size(),
             robot.collisions.size(), robot.visuals.size());
  print_drive(robot);
  print_lidar(robot);
  for (const std::string& warning : robot.warnings) fmt::print("warning: {}\n", warning);
  return kDone;
}

}  // namespace

void add_check_robot_command(CLI::App& app, std::function<int()>& chosen) {
  auto robot = std::make_shared<std::string>();
  CLI::App* command = app.add_subcommand("check-robot", "Print what is understood of a URDF");
  command->add_option("robot", *robot, "A robot's name or a .urdf")->required();
  command->footer("Example:\n  castaway check-robot my_robot.urdf");
  command->callback([&chosen, robot] { chosen = [robot] { return check_robot(*robot); }; });
}

}  // namespace castaway::testbed
