#include "tests/sim/support/test_world.hpp"

#include "sim/map/grid_tools.hpp"
#include "sim/map/rasterise.hpp"

namespace castaway::sim {

WorldObject box_on_floor(const std::string& name, const Eigen::Vector3d& size,
                         const Eigen::Vector2d& center, double yaw) {
  WorldObject object;
  object.name = name;
  object.shape = BoxShape{size};
  object.T_map_object = Eigen::Translation3d(center.x(), center.y(), 0.5 * size.z()) *
                        Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ());
  return object;
}

WorldSpec test_room() {
  WorldSpec world;
  world.name = "test_room";
  world.min_corner = {-4.1, -3.1};
  world.max_corner = {4.1, 3.1};
  world.objects = {box_on_floor("south", {8.2, 0.1, 1.0}, {0.0, -3.05}),
                   box_on_floor("north", {8.2, 0.1, 1.0}, {0.0, 3.05}),
                   box_on_floor("west", {0.1, 6.0, 1.0}, {-4.05, 0.0}),
                   box_on_floor("east", {0.1, 6.0, 1.0}, {4.05, 0.0}),
                   box_on_floor("table", {1.6, 0.8, 0.7}, {0.3, 0.2}, 0.4),
                   box_on_floor("shelf", {0.4, 1.5, 1.8}, {3.7, 1.0})};
  WorldObject pillar;
  pillar.name = "pillar";
  pillar.shape = CylinderShape{0.25, 2.0};
  pillar.T_map_object = Eigen::Translation3d(-2.0, -1.0, 1.0);
  world.objects.push_back(pillar);
  return world;
}

RobotModel test_robot() {
  RobotModel robot;
  robot.name = "test_robot";
  robot.chassis_mass = 1.7;
  robot.p_base_com = {-0.064, 0.0, 0.06};
  robot.inertia = Eigen::Vector3d(0.01, 0.01, 0.018).asDiagonal();
  RobotPart body;
  body.link = "base_link";
  body.shape = BoxShape{{0.266, 0.306, 0.12}};
  body.T_base_part = Eigen::Translation3d(-0.064, 0.0, 0.07);
  robot.collisions = {body};
  robot.visuals = {body};
  for (const double side : {1.0, -1.0}) {
    DriveWheel wheel;
    wheel.joint = wheel.link = side > 0.0 ? "left" : "right";
    wheel.p_base_wheel = {0.0, side * 0.1435, 0.033};
    wheel.radius = 0.033;
    wheel.mass = 0.0285;
    robot.wheels.push_back(wheel);
    robot.casters.push_back({{-0.177, side * 0.064, 0.01}, 0.01});
  }
  robot.wheel_radius = 0.033;
  robot.track = 0.287;
  robot.footprint_radius = 0.25;
  robot.height = 0.13;
  return robot;
}

SimulationConfig test_simulation() {
  SimulationConfig config;
  config.world = test_room();
  config.map = rasterise(config.world, 0.2, 0.05);
  config.robot = test_robot();
  config.lidars.front().noise.sigma = 0.0;
  config.odometry = ideal_odometry();
  config.drive.waypoints = {{2.5, -1.5}, {2.5, 2.0}, {-2.0, 2.0}, {-3.0, -2.0}};
  config.start = {-1.0, -2.0, 0.0};
  config.right_position = 0.5;
  config.right_yaw = 0.35;
  config.duration = std::chrono::seconds(10);
  return config;
}

SimulationConfig noisy_kidnap_simulation() {
  SimulationConfig config = test_simulation();
  config.odometry = OdometryConfig{};
  config.lidars.front().noise.sigma = 0.01;
  config.events.kidnaps = {{.when = {.value = 4.0}, .min_distance_m = 2.0}};
  return config;
}

SimulationStreams test_streams(unsigned seed) {
  return {Rng(3 * seed), Rng(3 * seed + 1), Rng(3 * seed + 2)};
}

Grid grid_from_art(const std::vector<std::string>& lines, double resolution) {
  const auto height = static_cast<int>(lines.size());
  const auto width = static_cast<int>(lines.front().size());
  Grid grid = make_grid(width, height, resolution, {0.0, 0.0}, Cell::kFree);
  for (int row = 0; row < height; ++row) {
    const std::string& line = lines[static_cast<std::size_t>(height - 1 - row)];
    for (int column = 0; column < width; ++column) {
      const char c = line[static_cast<std::size_t>(column)];
      if (c == '#') grid.cells[flat_index(grid, {column, row})] = Cell::kOccupied;
      if (c == '?') grid.cells[flat_index(grid, {column, row})] = Cell::kUnknown;
    }
  }
  return grid;
}

std::vector<std::string> art_of(const Grid& grid) {
  std::vector<std::string> lines;
  for (int row = grid.height - 1; row >= 0; --row) {
    std::string line;
    for (int column = 0; column < grid.width; ++column) {
      const Cell cell = grid.at(column, row);
      line += cell == Cell::kFree ? '.' : cell == Cell::kOccupied ? '#' : '?';
    }
    lines.push_back(line);
  }
  return lines;
}

}  // namespace castaway::sim
