#include "tools/batch/bench/bench_scene.hpp"

#include <cmath>
#include <numbers>

#include <boost/random/uniform_real_distribution.hpp>

#include "localization/map/ray_cast.hpp"
#include "tools/batch/trials/office_map.hpp"
#include "tools/build/map_conversion.hpp"

namespace castaway::testbed {
namespace {

using namespace localization;

constexpr double kBenchRange = 40.0;  // [m] Maximum range.
constexpr double kAround = 0.5;       // [m] Free space around the pose.
constexpr double kMaxDistance = 5.0;  // [m] Upper bound of the distance field.

SE2 roomy_pose(const OccupancyGrid& grid, const DistanceField& distances) {
  Rng rng = substream(1, "bench_scene/pose");
  const FreeSpace space(grid);
  SE2 pose = space.sample(rng);
  while (distances.at(grid.frame.T_map_grid.inverse() * pose.translation()) < kAround) {
    pose = space.sample(rng);
  }
  return pose;
}

LaserScan simulate_scan(const BenchSceneSpec& spec, const OccupancyGrid& grid,
                        const SE2& T_map_base) {
  const SE2 T_grid_base = grid.frame.T_map_grid.inverse() * T_map_base;
  const double cell = grid.frame.resolution;
  LaserScan scan;
  scan.angle_min = -std::numbers::pi;
  scan.angle_increment = 2.0 * std::numbers::pi / spec.beams;
  scan.range_min = 0.05;
  scan.range_max = kBenchRange;
  Rng rng = substream(1, "bench_scene/scan");
  boost::random::uniform_real_distribution<double> noise(-spec.noise, spec.noise);
  boost::random::uniform_real_distribution<double> unit;
  for (int i = 0; i < spec.beams; ++i) {
    const double heading = T_grid_base.yaw + scan.beam_angle(static_cast<std::size_t>(i));
    const Eigen::Vector2d direction(std::cos(heading), std::sin(heading));
    const double range =
        cell * cast_ray(grid, T_grid_base.translation() / cell, direction, kBenchRange / cell) +
        noise(rng);
    const bool is_blocked = unit(rng) < spec.blocked;
    scan.ranges.push_back(static_cast<float>(is_blocked ? std::min(range, 1.0) : range));
  }
  return scan;
}

ScanPoints project_points(const BenchSceneSpec& spec, const LaserScan& scan) {
  TransformBuffer still;
  still.add(scan.stamp, {});
  return project_scan(scan, still, scan.stamp, {spec.beams, kBenchRange}).value();
}

}  // namespace

BenchScene bench_scene(const BenchSceneSpec& spec) {
  OfficeSpec office;
  office.width = spec.width;
  office.height = spec.height;
  OccupancyGrid grid = to_occupancy_grid(draw_office(office));
  DistanceField distances(grid, kMaxDistance);
  const SE2 pose = roomy_pose(grid, distances);
  LaserScan scan = simulate_scan(spec, grid, pose);
  ScanPoints points = project_points(spec, scan);
  return {std::move(grid), std::move(distances), pose, std::move(scan), std::move(points)};
}

}  // namespace castaway::testbed
