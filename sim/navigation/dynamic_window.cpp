#include "sim/navigation/dynamic_window.hpp"

#include <algorithm>
#include <cmath>

namespace castaway::sim {
namespace {

constexpr int kSteps = 8;               // Poses checked along a roll-out.
constexpr double kHeadingWeight = 0.3;  // [m/rad]
constexpr double kRoomWeight = 1.0;     // [1] Cost of each metre below `comfort`.
constexpr double kFarAway = 10.0;       // [m] Room that is reported where there are no obstacles.
constexpr double kLeastGain = 0.01;     // [m] Cost by which a velocity must beat standing still.

/// Static end points and movers, in base.
struct Obstacles {
  std::vector<Eigen::Vector2d> points;
  std::vector<Mover> movers;
};

double room_at(const Eigen::Vector2d& p, const std::vector<Eigen::Vector2d>& points,
               double radius) {
  double nearest = kFarAway * kFarAway;
  for (const Eigen::Vector2d& point : points) {
    nearest = std::min(nearest, (point - p).squaredNorm());
  }
  return std::sqrt(nearest) - radius;
}

/// Least room to the movers ahead of a robot at `pose` after `t` seconds. [m]
double room_to_movers(const Pose2& pose, double t, const std::vector<Mover>& movers,
                      double radius) {
  double room = kFarAway;
  for (const Mover& mover : movers) {
    const Eigen::Vector2d p = inverse(pose) * Eigen::Vector2d(mover.p + t * mover.velocity);
    if (p.x() > 0.0) room = std::min(room, p.norm() - kMoverRadius - radius);
  }
  return room;
}

/// Points close enough to be reached within the horizon.
std::vector<Eigen::Vector2d> near(const std::vector<Eigen::Vector2d>& points, double reach) {
  std::vector<Eigen::Vector2d> result;
  for (const Eigen::Vector2d& p : points) {
    if (p.squaredNorm() < reach * reach) result.push_back(p);
  }
  return result;
}

/// Cost of a roll-out that ends at `end` with this least room along it.
double cost(const DynamicWindowConfig& config, const Pose2& end, const Eigen::Vector2d& target,
            double room) {
  const Eigen::Vector2d p_end = inverse(end) * target;
  const double heading = p_end.norm() < 0.05 ? 0.0 : std::abs(std::atan2(p_end.y(), p_end.x()));
  return p_end.norm() + kHeadingWeight * heading +
         kRoomWeight * std::max(config.comfort - room, 0.0);
}

/// Least room along the roll-out of a velocity [m]; nothing if that is below the margin. A robot
/// that starts closer than that to a static obstacle may move only if its room grows; for a mover
/// it waits.
std::optional<double> room_along(const DynamicWindowConfig& config, const Twist2& twist,
                                 const Obstacles& obstacles) {
  double before = room_at({0.0, 0.0}, obstacles.points, config.radius);
  double least = before;
  for (int i = 1; i <= kSteps; ++i) {
    const double t = config.horizon * i / kSteps;
    const Pose2 pose = arc(twist.v * t, twist.w * t);
    const double room = room_at(pose.position(), obstacles.points, config.radius);
    const double moving = room_to_movers(pose, t, obstacles.movers, config.radius);
    const bool squeezed = room < config.margin && room <= before;
    if (twist.v != 0.0 && (squeezed || moving < config.margin)) return std::nullopt;
    before = room;
    least = std::min({least, room, moving});
  }
  return least;
}

double sample(double low, double high, int i, int count) {
  return low + (high - low) * i / (count - 1);
}

}  // namespace

std::optional<Twist2> best_twist(const DynamicWindowConfig& config, const Twist2& current,
                                 const Eigen::Vector2d& p_base_target,
                                 const std::vector<Eigen::Vector2d>& p_base,
                                 const std::vector<Mover>& movers) {
  const TwistLimits& limits = config.limits;
  const Obstacles obstacles{
      near(p_base, limits.max_speed * config.horizon + config.radius + config.comfort), movers};
  const double dv = limits.max_acceleration * config.window;
  const double dw = limits.max_turn_acceleration * config.window;
  const double still = room_at({0.0, 0.0}, obstacles.points, config.radius);
  double best_cost = cost(config, {}, p_base_target, still) - kLeastGain;
  std::optional<Twist2> best;
  for (int i = 0; i < config.speeds; ++i) {
    const double v = sample(std::max(current.v - dv, 0.0),
                            std::clamp(current.v + dv, 0.0, limits.max_speed), i, config.speeds);
    for (int k = 0; k < config.turns; ++k) {
      const double w = sample(std::max(current.w - dw, -limits.max_turn_rate),
                              std::min(current.w + dw, limits.max_turn_rate), k, config.turns);
      const auto room = room_along(config, {v, w}, obstacles);
      if (!room) continue;
      const Pose2 end = arc(v * config.horizon, w * config.horizon);
      const double rating = cost(config, end, p_base_target, *room);
      if (rating >= best_cost) continue;
      best_cost = rating;
      best = Twist2{v, w};
    }
  }
  return best;
}

}  // namespace castaway::sim
