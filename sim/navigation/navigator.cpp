#include "sim/navigation/navigator.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "sim/map/grid_tools.hpp"

namespace castaway::sim {
namespace {

// [m] An obstacle this close to the footprint where it would stop is a danger.
constexpr double kStopRoom = 0.01;
// [s] After braking, the robot stands still for at least this long.
constexpr double kStopPause = 0.5;
constexpr double kStopFrom = 0.15;     // [m/s] Stopping from a lower speed is not an emergency.
constexpr double kMarkedWithin = 4.0;  // [m] A new plan avoids end points within this range.
constexpr double kMapped = 0.25;    // [m] End points this close to a mapped obstacle belong to it.
constexpr double kKeepAway = 0.05;  // [m] Distance around each end point that is marked, too.
constexpr double kStride = 0.5;   // [m] A leg can be this far from the middle of a walking person.
constexpr double kSeenAgo = 0.2;  // [s] End points are at most this old.
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

/// Movers in frame b, given in frame a.
std::vector<Mover> transform_movers(std::vector<Mover> movers, const Pose2& T_b_a) {
  const Pose2 turn{0.0, 0.0, T_b_a.yaw};
  for (Mover& mover : movers) mover = {T_b_a * mover.p, turn * mover.velocity};
  return movers;
}

}  // namespace

Navigator::Navigator(const NavigatorConfig& config, const Grid& map)
    : config_(config),
      map_(map),
      mapped_(map, kMapped),
      route_(config.route, FreeSpace(map, plan_radius(config))),
      passing_({.radius = config.local.radius}),
      recoveries_(config.recoveries, config.local.radius + config.local.margin, config.period) {}

void Navigator::replan(const Pose2& T_map_base, const std::vector<Eigen::Vector2d>& p_base) {
  route_.detour(T_map_base, FreeSpace(with_points(map_, T_map_base, p_base), plan_radius(config_)));
}

Twist2 Navigator::drive(const Pose2& T_map_base, const std::vector<Eigen::Vector2d>& p_base) {
  const Twist2 wanted = route_.command(T_map_base);
  const auto lane = route_.lane();
  if (!lane) return {};
  if (const auto recovery = recoveries_.watch(live_.T_odom_base())) {
    events_.push_back(to_string(*recovery));
    if (*recovery == Recovery::kReplan) replan(T_map_base, p_base);
  }
  if (const auto twist = recoveries_.command(live_.T_odom_base(), p_base)) return *twist;
  if (wanted.v == 0.0) return wanted;  // A turn on the spot is free: the robot is a disc.
  std::vector<Eigen::Vector2d> p_base_still = p_base;
  std::erase_if(p_base_still,
                [&](const Eigen::Vector2d& p) { return !velocity_at(p, T_map_base).isZero(0.0); });
  const std::vector<Mover> movers = transform_movers(seen_, T_map_base);
  DynamicWindowConfig local = config_.local;
  const Twist2 now = live_.twist();
  local.limits.max_speed = passing_pace(
      {local.limits.max_speed, kBrakingShare * local.limits.max_acceleration, local.radius}, *lane,
      offset_from(*lane, T_map_base), movers);
  const Eigen::Vector2d aim = passing_.choose_target(*lane, now.v, movers, mapped_);
  return best_twist(local, now, inverse(T_map_base) * aim, p_base_still, moving_)
      .value_or(Twist2{});
}

/// Updates the tracks with end points that are not on the map.
void Navigator::watch_movers(const Pose2& T_map_base) {
  const Pose2 T_odom_base = live_.T_odom_base();
  const Pose2 T_map_odom = T_map_base * inverse(T_odom_base);
  for (std::vector<SeenPoint>& points : live_.take_new_scans()) {
    std::erase_if(points, [&](const SeenPoint& point) {
      return mapped_.clearance_at(T_map_odom * point.p) <= kMapped;
    });
    movers_.update(points);
  }
  seen_ = transform_movers(movers_.extrapolate(live_.stamp()), inverse(T_odom_base));
  moving_ = seen_;
  std::erase_if(moving_, [](const Mover& mover) { return mover.stands(); });
}

namespace {

/// What happens if the robot brakes now.
struct Braking {
  double side = 1.0;      ///< -1 if it drives backwards.
  double duration = 0.0;  ///< [s]
  Eigen::Vector2d stop;   ///< [m] Where it stops, in base.
};

Braking braking_from(const Twist2& now, double deceleration) {
  const double speed = std::abs(now.v);
  const double side = now.v >= 0.0 ? 1.0 : -1.0;
  const double duration = speed / deceleration;
  const double way = 0.5 * speed * duration;
  const double turn = speed > 0.0 ? now.w / speed * way : 0.0;
  return {side, duration, arc(side * way, turn).position()};
}

}  // namespace

/// Overrides a command that would run the robot into something before it could brake.
Twist2 Navigator::stop_in_emergency(const Twist2& twist, const Pose2& T_map_base,
                                    const std::vector<Eigen::Vector2d>& p_base) {
  const Twist2 now = live_.twist();
  const Braking braking = braking_from(now, config_.local.limits.max_acceleration);
  const double reach = config_.local.radius + kStopRoom;
  const bool danger = std::any_of(p_base.begin(), p_base.end(), [&](const Eigen::Vector2d& p) {
    // An obstacle that moves away is tested where it will be when the robot has stopped.
    const Eigen::Vector2d v = velocity_at(p, T_map_base);
    const Eigen::Vector2d then = v.dot(p) > 0.0 ? Eigen::Vector2d(p + braking.duration * v) : p;
    return braking.side * p.x() > 0.0 && std::min((then - braking.stop).norm(), p.norm()) < reach;
  });
  const bool moves = std::abs(now.v) > kStopFrom;
  if (danger && moves && stop_left_ <= 0.0) events_.emplace_back("emergency stop");
  if (danger && (moves || stop_left_ > 0.0)) {
    stop_left_ = std::max(stop_left_, braking.duration + kStopPause);
  }
  stop_left_ -= config_.period;
  return stop_left_ > 0.0 ? Twist2{0.0, 0.0} : twist;
}

/// Velocity, in base, of the mover that a point belongs to, by the mover's position now or when the
/// point was seen. Zero for other points and for points on the map: a wall does not move with a
/// person who passes it.
Eigen::Vector2d Navigator::velocity_at(const Eigen::Vector2d& p_base,
                                       const Pose2& T_map_base) const {
  for (const Mover& mover : moving_) {
    const Eigen::Vector2d way = kSeenAgo * mover.velocity;
    const double ago = std::clamp((mover.p - p_base).dot(way) / way.squaredNorm(), 0.0, 1.0);
    if ((mover.p - ago * way - p_base).norm() >= kStride) continue;
    const bool mapped = mapped_.clearance_at(T_map_base * p_base) <= kMapped;
    return mapped ? Eigen::Vector2d::Zero().eval() : mover.velocity;
  }
  return Eigen::Vector2d::Zero();
}

Twist2 Navigator::command(const std::optional<Pose2>& T_map_base) {
  Twist2 twist;
  if (T_map_base) {
    const std::vector<Eigen::Vector2d> p_base = live_.p_base();
    watch_movers(*T_map_base);
    twist = stop_in_emergency(drive(*T_map_base, p_base), *T_map_base, p_base);
  }
  return twist;
}

std::vector<std::string> Navigator::take_events() { return std::exchange(events_, {}); }

}  // namespace castaway::sim
