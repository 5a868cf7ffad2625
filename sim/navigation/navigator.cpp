#include "sim/navigation/navigator.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "sim/map/grid_tools.hpp"

namespace castaway::sim {
namespace {

constexpr double kMarkedWithin = 4.0;  // [m] A new plan avoids end points within this range.
constexpr double kKeepAway = 0.05;     // [m] Distance around each end point that is marked, too.
constexpr double kBrakingShare = 0.5;  // Share of the acceleration limit that braking counts on.

double plan_radius(const NavigatorConfig& config) {
  return config.local.radius + config.plan_margin;
}

/// The map with the nearby end points marked as occupied.
Grid with_points(const Grid& map, const Pose2& T_map_base,
                 const std::vector<Eigen::Vector2d>& p_base) {
  Grid grid = map;
  for (const Eigen::Vector2d& p : p_base) {
    if (p.norm() > kMarkedWithin) continue;
    for (const Eigen::Vector2d& offset :
         {Eigen::Vector2d(0.0, 0.0), Eigen::Vector2d(kKeepAway, 0.0),
          Eigen::Vector2d(-kKeepAway, 0.0), Eigen::Vector2d(0.0, kKeepAway),
          Eigen::Vector2d(0.0, -kKeepAway)}) {
      const CellIndex cell = cell_of(grid, T_map_base * Eigen::Vector2d(p + offset));
      if (grid.contains(cell.column, cell.row)) {
        grid.cells[flat_index(grid, cell)] = Cell::kOccupied;
      }
    }
  }
  return grid;
}

/// Signed distance of the robot from a lane, left positive. [m]
double offset_from(const Lane& lane, const Pose2& T_map_base) {
  const Eigen::Vector2d along = (lane.to - lane.from).normalized();
  return Eigen::Vector2d(-along.y(), along.x()).dot(T_map_base.position() - lane.from);
}

}  // namespace

Navigator::Navigator(const NavigatorConfig& config, const Grid& map)
    : config_(config),
      map_(map),
      route_(config.route, FreeSpace(map, plan_radius(config))),
      watch_(map),
      passing_({.radius = config.local.radius}),
      recoveries_(config.recoveries, config.local.radius + config.local.margin, config.period),
      stop_({config.local.radius, config.local.limits.max_acceleration, config.period}) {}

Twist2 Navigator::drive(const Pose2& T_map_base, const std::vector<Eigen::Vector2d>& p_base) {
  const Twist2 wanted = route_.command(T_map_base);
  const auto lane = route_.lane();
  if (!lane) return {};
  if (const auto recovery = recoveries_.watch(live_.T_odom_base())) {
    events_.push_back({*recovery});
    if (*recovery == Recovery::kReplan) {
      const Grid seen = with_points(map_, T_map_base, p_base);
      route_.detour(T_map_base, FreeSpace(seen, plan_radius(config_)));
    }
  }
  if (const auto twist = recoveries_.command(live_.T_odom_base(), p_base)) return *twist;
  if (wanted.v == 0.0) return wanted;  // A turn on the spot is free: the robot is a disc.
  std::vector<Eigen::Vector2d> p_base_still = p_base;
  std::erase_if(p_base_still, [&](const Eigen::Vector2d& p) {
    return !watch_.velocity_at(p, T_map_base).isZero(0.0);
  });
  const std::vector<Mover> movers = transform_movers(watch_.seen(), T_map_base);
  DynamicWindowConfig local = config_.local;
  const Twist2 now = live_.twist();
  local.limits.max_speed = passing_pace(
      {local.limits.max_speed, kBrakingShare * local.limits.max_acceleration, local.radius}, *lane,
      offset_from(*lane, T_map_base), movers);
  const Eigen::Vector2d aim = passing_.choose_target(*lane, now.v, movers, watch_.mapped());
  return best_twist(local, now, inverse(T_map_base) * aim, p_base_still, watch_.moving())
      .value_or(Twist2{});
}

Twist2 Navigator::command(const std::optional<Pose2>& T_map_base) {
  if (!T_map_base) return {};
  const std::vector<Eigen::Vector2d> p_base = live_.p_base();
  watch_.update(live_, *T_map_base);
  const Twist2 twist = drive(*T_map_base, p_base);
  const EmergencyStop::Order order =
      stop_.watch(live_.twist(), p_base,
                  [&](const Eigen::Vector2d& p) { return watch_.velocity_at(p, *T_map_base); });
  if (order.begins) events_.push_back({Driving::Stop{}});
  return order.stop ? Twist2{} : twist;
}

std::vector<Driving> Navigator::take_events() { return std::exchange(events_, {}); }

}  // namespace castaway::sim
