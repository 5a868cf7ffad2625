#include "tools/build/build_drive.hpp"

#include <algorithm>
#include <limits>
#include <stdexcept>

#include <fmt/format.h>

#include "localization/geometry/random.hpp"
#include "sim/map/free_space.hpp"
#include "sim/map/level_plane.hpp"
#include "tools/base/formats/tum.hpp"
#include "tools/base/formats/twist_log.hpp"
#include "tools/build/sim_conversion.hpp"
#include "tools/scenario/files/data_paths.hpp"
#include "tools/scenario/yaml/nearest.hpp"

namespace castaway::testbed {
namespace {

constexpr int kRandomWaypoints = 30;
constexpr int kCandidates = 2000;      // Candidate places for "explore".
constexpr std::size_t kExplored = 60;  // Places chosen from the candidates.
constexpr double kRouteMargin = 0.1;   // [m] around the footprint

using Route = std::vector<Eigen::Vector2d>;

Eigen::Vector2d drawn_place(const sim::FreeSpace& space, localization::Rng& rng) {
  return space.sample(rng)->position();
}

Route random_route(const sim::FreeSpace& space, localization::Rng& rng, int places) {
  Route route;
  for (int i = 0; i < places; ++i) route.push_back(drawn_place(space, rng));
  return route;
}

Route exploring_route(const sim::FreeSpace& space, localization::Rng& rng) {
  const Route candidates = random_route(space, rng, kCandidates);
  Route route{candidates.front()};
  std::vector<double> away(candidates.size(), std::numeric_limits<double>::infinity());
  while (route.size() < kExplored) {
    for (std::size_t i = 0; i < candidates.size(); ++i) {
      away[i] = std::min(away[i], (candidates[i] - route.back()).norm());
    }
    const auto farthest = std::max_element(away.begin(), away.end()) - away.begin();
    route.push_back(candidates[static_cast<std::size_t>(farthest)]);
  }
  return route;
}

/// Where a route comes from.
enum class RouteSource { kNone, kRandom, kExplore, kWorld };

RouteSource source_of(const std::string& route, bool world_has_routes) {
  if (route == "none") return RouteSource::kNone;
  if (route == "explore") return RouteSource::kExplore;
  const bool random = route == "random" || (route.empty() && !world_has_routes);
  return random ? RouteSource::kRandom : RouteSource::kWorld;
}

Route drawn_route(RouteSource source, const RouteWorld& world, const sim::RobotModel& robot,
                  std::uint64_t seed) {
  const double radius = robot.footprint_radius + kRouteMargin;
  const sim::FreeSpace space = world.levels ? sim::FreeSpace::on_levels(world.levels, radius)
                                            : world.spaces->on_map(*world.grid, radius);
  localization::Rng rng = localization::substream(seed, "route");
  localization::Rng any;
  if (!space.sample(any)) {
    throw std::runtime_error(
        fmt::format("world {} has no place where the robot, {:.2f} m in radius, fits; "
                    "castaway check-world shows its free space",
                    world.name, robot.footprint_radius));
  }
  return source == RouteSource::kExplore ? exploring_route(space, rng)
                                         : random_route(space, rng, kRandomWaypoints);
}

/// A route of a world with floors is on the lowest ground.
Route on_ground(Route route, const sim::LevelPlane* levels) {
  if (levels == nullptr) return route;
  for (Eigen::Vector2d& p : route) {
    const auto found = levels->on_level({p.x(), p.y(), 0.0}, std::nullopt);
    if (found) p = found->position();
  }
  return route;
}

Route route_of(const Scenario& scenario, const RouteWorld& world, const sim::RobotModel& robot) {
  const auto& routes = *world.routes;
  const std::string& name = scenario.drive.route;
  const RouteSource source = source_of(name, !routes.empty());
  if (source == RouteSource::kNone) return {};
  if (source != RouteSource::kWorld) return drawn_route(source, world, robot, scenario.seed);
  if (name.empty()) return on_ground(routes.begin()->second, world.levels.get());
  const auto found = routes.find(name);
  if (found != routes.end()) return on_ground(found->second, world.levels.get());
  std::vector<std::string> known = {"random", "explore", "none"};
  for (const auto& [other, points] : routes) known.push_back(other);
  throw std::runtime_error(fmt::format("drive.route: world '{}' has no route '{}'; {}", world.name,
                                       name, suggestion(name, known)));
}

/// The poses of a file, with times since its first one.
std::vector<sim::TimedPose> read_path(const std::filesystem::path& file) {
  std::vector<sim::TimedPose> path;
  std::optional<std::chrono::nanoseconds> first;
  for (const StampedPose& pose : read_tum(file)) {
    if (!first) first = pose.stamp;
    path.push_back({localization::seconds(pose.stamp - *first), to_pose2(pose.T_map_base)});
  }
  return path;
}

}  // namespace

sim::DriveConfig build_drive(const Scenario& scenario, const std::filesystem::path& base,
                             const RouteWorld& world, const sim::RobotModel& robot) {
  const DriveSpec& spec = scenario.drive;
  sim::DriveConfig drive;
  drive.by_estimate = !spec.by_truth();
  drive.limits = spec.limits;
  drive.wait_s = spec.wait_s;
  if (!spec.path.empty()) {
    drive.path = read_path(find_file(spec.path, base));
  } else if (spec.twist_log.empty()) {
    drive.waypoints = route_of(scenario, world, robot);
  } else {
    for (const TwistLine& line : read_twist_log(find_file(spec.twist_log, base))) {
      drive.log.push_back({line.t_s, {line.v, line.w}});
    }
  }
  return drive;
}

}  // namespace castaway::testbed
