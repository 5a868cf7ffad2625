#include "tools/batch/bench/simulation_bench.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include <fmt/format.h>

#include "castaway/stamp.hpp"
#include "localization/geometry/random.hpp"
#include "sim/casting/moving_scene.hpp"
#include "sim/common/random.hpp"
#include "sim/map/free_space.hpp"
#include "sim/map/rasterise.hpp"
#include "sim/people/bodies/person_rays.hpp"
#include "sim/sensor/lidar.hpp"
#include "sim/world/world.hpp"
#include "tools/base/process/cpu_clock.hpp"
#include "tools/build/build_simulation.hpp"
#include "tools/build/simulator_source.hpp"

namespace castaway::testbed {
namespace {

Eigen::Vector2d place(double edge, sim::Rng& rng) {
  const double x = sim::draw_between(-0.5 * edge, 0.5 * edge, rng);
  return {x, sim::draw_between(-0.5 * edge, 0.5 * edge, rng)};
}

/// Boxes of 0.2 to 1.5 m at random poses in a square hall without walls, centred at the origin,
/// with edge `edge` [m].
sim::WorldSpec bench_hall(int boxes, double edge, std::uint64_t seed) {
  sim::Rng rng = localization::substream(seed, "hall");
  sim::WorldSpec world;
  world.name = "hall";
  world.max_corner = Eigen::Vector2d::Constant(0.5 * edge);
  world.min_corner = -world.max_corner;
  for (int i = 0; i < boxes; ++i) {
    const double width = sim::draw_between(0.2, 1.5, rng);
    const double depth = sim::draw_between(0.1, 0.6, rng);
    const Eigen::Vector2d p = place(edge, rng);
    const double yaw = sim::draw_between(-std::numbers::pi, std::numbers::pi, rng);
    sim::WorldObject box;
    box.name = fmt::format("box_{}", i);
    box.shape = sim::BoxShape{{width, depth, 1.0}};
    box.T_map_object =
        Eigen::Translation3d(p.x(), p.y(), 0.5) * Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ());
    world.objects.push_back(std::move(box));
  }
  return world;
}

/// Walking people at random places in the hall.
std::vector<sim::MovingBody> bench_people(int count, double edge, std::uint64_t seed) {
  sim::Rng rng = localization::substream(seed, "people");
  std::vector<sim::MovingBody> bodies;
  for (int i = 0; i < count; ++i) {
    sim::PersonState state;
    state.position = place(edge, rng);
    state.heading = sim::draw_between(-std::numbers::pi, std::numbers::pi, rng);
    const Eigen::Vector2d ahead = sim::heading_vector(state.heading);
    const Eigen::Vector2d left(-ahead.y(), ahead.x());
    const double stride = sim::draw_between(-0.35, 0.35, rng);
    state.feet = {state.position + stride * ahead + sim::kFootSpread * left,
                  state.position - stride * ahead - sim::kFootSpread * left};
    bodies.push_back(sim::person_rays({}, state, i));
  }
  return bodies;
}

constexpr std::uint64_t kSeed = 1;
constexpr double kRoomPerBox = 1.7;  // [m^2]
constexpr double kCastEdge = 20.0;   // [m]
constexpr double kCastRange = 12.0;  // [m]
constexpr int kBeams = 360;
constexpr int kBenchWaypoints = 12;

sim::SimulationConfig lab() {
  Scenario scenario;
  scenario.lidars.front().set("rate_hz", 10.0).set("range_max", kCastRange);
  return build_simulation(scenario, ".").config;
}

sim::SimulationConfig in_hall(int boxes) {
  sim::SimulationConfig config = lab();
  config.world = bench_hall(boxes, std::sqrt(kRoomPerBox * boxes), kSeed);
  config.map =
      sim::rasterise(config.world, config.lidars.front().T_base_laser.translation().z(), 0.05);
  config.random_start = true;
  config.drive.waypoints.clear();
  sim::Rng rng = simulation_streams(kSeed).named("route");
  const sim::FreeSpace free(config.map, config.robot.footprint_radius + 0.1);
  for (int i = 0; i < kBenchWaypoints; ++i) {
    if (const auto pose = free.sample(rng)) config.drive.waypoints.push_back(pose->position());
  }
  return config;
}

/// Calls `scan` with origins all over the hall until `wanted_s` has passed. Returns scans per
/// second.
template <typename Scan>
double scans_per_s(double wanted_s, Scan scan) {
  constexpr double kGolden = 0.6180339887498949;  // The golden ratio spreads the places evenly.
  const std::chrono::nanoseconds begin = thread_cpu_time();
  double spent = 0.0;
  int count = 0;
  while (spent < wanted_s) {
    for (int k = 0; k < 20; ++k, ++count) {
      const double x = std::fmod(0.5 + kGolden * count, 1.0) - 0.5;
      const double y = std::fmod(0.5 + kGolden * kGolden * count, 1.0) - 0.5;
      scan(Eigen::Vector3d(0.9 * kCastEdge * x, 0.9 * kCastEdge * y, 0.2));
    }
    spent = localization::seconds(thread_cpu_time() - begin);
  }
  return count / spent;
}

std::vector<Eigen::Vector3d> directions() {
  std::vector<Eigen::Vector3d> result;
  for (int i = 0; i < kBeams; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / kBeams;
    result.emplace_back(std::cos(angle), std::sin(angle), 0.0);
  }
  return result;
}

double plain_cast(const std::vector<sim::RayPrimitive>& primitives,
                  const std::vector<sim::MovingBody>& people, const sim::Ray& ray) {
  double nearest = kCastRange;
  for (const auto& primitive : primitives) nearest = std::min(nearest, intersect(primitive, ray));
  for (const sim::MovingBody& body : people) {
    for (std::size_t i = 0; i < body.count; ++i) {
      nearest = std::min(nearest, intersect(body.parts[i], ray));
    }
  }
  return nearest;
}

}  // namespace

SimulationCost time_simulation(const SimulationCostSpec& spec) {
  sim::SimulationConfig config = spec.obstacles > 0 ? in_hall(spec.obstacles) : lab();
  sim::LidarConfig& lidar = config.lidars.front();
  lidar.angle_increment *= static_cast<double>(lidar.beams) / spec.beams;
  lidar.beams = spec.beams;
  config.people.walking = spec.people;
  config.physics_hz = spec.kinematic ? 100.0 : 240.0;
  if (spec.kinematic) config.drive_model = sim::DriveModel::kKinematic;
  config.duration = localization::from_seconds(spec.duration_s);
  sim::Simulation staged(config, simulation_streams(kSeed), thread_cpu_time);
  while (staged.next()) {
  }
  sim::Simulation simulation(std::move(config), simulation_streams(kSeed));
  const std::chrono::nanoseconds begin = thread_cpu_time();
  while (simulation.next()) {
  }
  SimulationCost cost{spec, 0.0, {}};
  cost.realtime_factor = spec.duration_s / localization::seconds(thread_cpu_time() - begin);
  for (const auto& [stage, cpu] : staged.cpu_by_stage()) {
    cost.cpu_s[stage] = localization::seconds(cpu);
  }
  return cost;
}

CastSpeed time_casts(int boxes, int people, double seconds) {
  const auto primitives = sim::ray_primitives(bench_hall(boxes, kCastEdge, kSeed));
  const auto bodies = bench_people(people, kCastEdge, kSeed);
  const sim::RayScene scene(primitives);
  const sim::MovingScene moving(bodies);
  const sim::Surroundings around(scene, moving);
  const std::vector<Eigen::Vector3d> beams = directions();
  volatile double sink = 0.0;
  const double scans = scans_per_s(seconds, [&](const Eigen::Vector3d& origin) {
    std::uint32_t guess = sim::kNoPrimitive;
    double sum = 0.0;
    for (const Eigen::Vector3d& direction : beams) {
      const auto hit = sim::cast(around, {origin, direction}, kCastRange, guess);
      sum += hit ? hit->distance : kCastRange;
      guess = hit ? hit->primitive : guess;
    }
    sink = sum;
  });
  const double plain = scans_per_s(seconds, [&](const Eigen::Vector3d& origin) {
    double sum = 0.0;
    for (const Eigen::Vector3d& beam : beams) sum += plain_cast(primitives, bodies, {origin, beam});
    sink = sum;
  });
  return {boxes, people, kBeams * scans, kBeams * plain};
}

}  // namespace castaway::testbed
