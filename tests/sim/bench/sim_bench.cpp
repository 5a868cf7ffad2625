/// Measures the simulator: rays per second, and simulated time over real time. Not a test.
#include <chrono>
#include <cstdio>
#include <ctime>
#include <numbers>

#include "sim/casting/ray_scene.hpp"
#include "sim/common/random.hpp"
#include "sim/map/extrude.hpp"
#include "sim/map/free_space.hpp"
#include "sim/map/rasterise.hpp"
#include "sim/robot/load_robot.hpp"
#include "tests/sim/support/test_world.hpp"

namespace {

using namespace castaway::sim;
using std::chrono::nanoseconds;

nanoseconds cpu_now() {
  timespec t{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return std::chrono::seconds(t.tv_sec) + nanoseconds(t.tv_nsec);
}

double seconds(nanoseconds t) { return std::chrono::duration<double>(t).count(); }

/// Boxes in a hall of 20 m x 20 m.
WorldSpec hall(int boxes) {
  Rng rng(1);
  WorldSpec world;
  world.min_corner = {-10.0, -10.0};
  world.max_corner = {10.0, 10.0};
  for (int i = 0; i < boxes; ++i) {
    const Eigen::Vector3d size(draw_between(0.2, 1.5, rng), draw_between(0.1, 0.6, rng), 1.0);
    const Eigen::Vector2d center(draw_between(-10.0, 10.0, rng), draw_between(-10.0, 10.0, rng));
    world.objects.push_back(
        box_on_floor("box_" + std::to_string(i), size, center, draw_between(-3.0, 3.0, rng)));
  }
  return world;
}

void time_rays(const char* name, const WorldSpec& world) {
  const RayScene scene(ray_primitives(world));
  Rng rng(2);
  double sum = 0.0;
  constexpr int kScans = 6000;
  const nanoseconds before = cpu_now();
  for (int scan = 0; scan < kScans; ++scan) {
    const Eigen::Vector3d origin(draw_between(-9.0, 9.0, rng), draw_between(-9.0, 9.0, rng), 0.2);
    for (int beam = 0; beam < 360; ++beam) {
      const double angle = 2.0 * std::numbers::pi * beam / 360.0;
      const auto hit = scene.cast({origin, {std::cos(angle), std::sin(angle), 0.0}}, 12.0);
      sum += hit ? hit->distance : 12.0;
    }
  }
  std::printf("%-28s %6zu shapes  %5.2f M rays/s  (mean range %.2f m)\n", name,
              scene.primitives().size(), 360e-6 * kScans / seconds(cpu_now() - before),
              sum / (360.0 * kScans));
}

void time_run(const char* name, SimulationConfig config) {
  config.duration = std::chrono::seconds(120);
  const nanoseconds start = cpu_now();
  Simulation simulation(config, test_streams(1), cpu_now);
  const nanoseconds built = cpu_now();
  while (simulation.next()) {
  }
  const nanoseconds done = cpu_now();
  std::printf("%-28s %4.0fx real time (set-up %.0f ms;", name, 120.0 / seconds(done - built),
              1e3 * seconds(built - start));
  for (const auto& [stage, cpu] : simulation.cpu_by_stage()) {
    std::printf(" %s %.0f ms", stage.c_str(), 1e3 * seconds(cpu));
  }
  std::printf("), driven %.1f m, %ld collisions\n", simulation.distance_driven(),
              static_cast<long>(simulation.collisions()));
}

/// A map of 60 m x 60 m at 5 cm with rooms and the specks of a real map.
Grid big_map() {
  Rng rng(3);
  Grid grid = make_grid(1200, 1200, 0.05, {-30.0, -30.0}, Cell::kFree);
  for (int row = 0; row < grid.height; ++row) {
    for (int column = 0; column < grid.width; ++column) {
      const bool wall = (row % 200 < 3 && column % 200 > 40) ||
                        (column % 200 < 3 && row % 200 > 40) || row > 1196 || column > 1196;
      const bool speck = draw_between(0.0, 1.0, rng) < 0.0005;
      if (wall ? draw_between(0.0, 1.0, rng) < 0.97 : speck) {
        grid.cells[flat_index(grid, {column, row})] = Cell::kOccupied;
      }
    }
  }
  return grid;
}

SimulationConfig big_run() {
  SimulationConfig config = test_simulation();
  config.map = big_map();
  config.world = extrude(config.map, 1.0, "big");
  config.robot = load_robot(CASTAWAY_ROBOTS "/waffle/waffle.urdf");
  config.random_start = true;
  config.drive.waypoints = {{-20.0, -20.0}, {20.0, -20.0}, {20.0, 20.0}, {-20.0, 20.0}};
  return config;
}

}  // namespace

int main() {
  time_rays("60 turned boxes", hall(60));
  time_rays("920 turned boxes", hall(920));
  SimulationConfig room = test_simulation();
  room.robot = load_robot(CASTAWAY_ROBOTS "/waffle/waffle.urdf");
  room.lidars.front().T_base_laser = room.robot.lidar->T_base_laser;
  room.lidars.front().noise.sigma = 0.01;
  room.odometry = OdometryConfig{};
  time_run("room, 500 Hz", room);
  room.physics_hz = 240.0;
  time_run("room, 240 Hz", room);
  const nanoseconds before = cpu_now();
  const SimulationConfig big = big_run();
  std::printf("extruded 1200 x 1200 cells into %zu boxes in %.0f ms\n", big.world.objects.size(),
              1e3 * seconds(cpu_now() - before));
  time_rays("big map", big.world);
  time_run("big map, 500 Hz", big);
  return 0;
}
