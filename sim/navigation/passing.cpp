#include "sim/navigation/passing.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace castaway::sim {
namespace {

constexpr double kStep = 0.1;        // [m] Between the offsets tried...
constexpr int kPassingSteps = 9;     // ...so many to each side.
constexpr double kAsideCost = 0.3;   // Of each metre from where it would drive by itself...
constexpr double kChangeCost = 0.1;  // ...of each metre from where it drove last...
constexpr double kCrossCost = 0.6;  // ...of those metres while somebody comes: no change of mind...
constexpr double kCrowdedCost = 4.0;     // ...and of each metre of room that is missing.
constexpr double kSlowestPassing = 0.4;  // [m/s] Reckoned with, even while it stands.
constexpr double kDrift = 0.4;           // [s] For which somebody's way across is carried on.
constexpr double kFarthest = 5.0;        // [s] Meetings that are minded.
constexpr double kLeastRoom = 0.05;      // [m] To what the map has...
constexpr double kEnough = 0.2;          // [m] ...and where nobody makes it go there.
constexpr double kShortest = 0.8;        // [m] Lane along which it is worth while to keep aside.
constexpr double kBeside = 1.2;          // [m] Further off the lane, nobody slows the robot down.
constexpr double kPaceGap = 1.5;         // [m] From a mover at which the robot creeps...
constexpr double kSlowPace = 0.2;        // [m/s] ...so slowly...
constexpr double kPaceGain = 0.35;       // [1/s] ...and how much faster for each metre more.
constexpr double kWayRoom = 0.15;        // [m] From a mover that is not in the way.
constexpr double kDriftInWay = 1.0;      // [s] For which somebody's way across may lead into it.
constexpr double kNotice = 0.5;          // [s] Until a scan is seen and acted upon.
constexpr double kFarAhead = 9.0;        // [m] Nobody there matters.
constexpr double kSetsOff = 1.2;         // [m/s] With which who stands or walks ahead may come...
constexpr double kPassStanding = 0.3;    // [m/s] ...and at which they are passed however near.
constexpr double kOvertaking = 0.5;      // [s] Before who overtakes is ahead, they are minded.

Eigen::Vector2d left_of(const Eigen::Vector2d& along) { return {-along.y(), along.x()}; }

/// Seen along a lane.
struct Meeting {
  double gap;     ///< [m] Ahead.
  double across;  ///< [m] To the left.
  double coming;  ///< [m/s] Towards the robot.
  double aside;   ///< [m/s] To the left.
};

Meeting meeting(const Lane& lane, const Mover& mover) {
  const Eigen::Vector2d along = (lane.to - lane.from).normalized();
  const Eigen::Vector2d left = left_of(along);
  const Eigen::Vector2d p = mover.p - lane.from;
  return {p.dot(along), p.dot(left), -mover.velocity.dot(along), mover.velocity.dot(left)};
}

/// True if robot and mover, keeping their ways, come nearer than they should.
bool is_in_way(const PaceConfig& config, const Meeting& m, double offset) {
  const double closing = std::max(m.coming + 0.5 * config.max_speed, kSlowestPassing);
  const double then = m.across + std::min(m.gap / closing, kDriftInWay) * m.aside;
  const double least = config.radius + kMoverRadius + kWayRoom;
  return std::min(std::abs(m.across - offset), std::abs(then - offset)) < least ||
         (m.across - offset) * (then - offset) < 0.0;
}

/// From which the robot stands by the time that somebody is there:
/// v^2 / (2 a) + (v / a + kNotice) coming = room.
double stopping_pace(const PaceConfig& config, const Meeting& m) {
  const double u = std::max(m.coming, 0.0);
  const double room = m.gap - config.radius - kMoverRadius - kWayRoom - kNotice * u;
  const double a = config.deceleration;
  return std::sqrt(u * u + 2.0 * a * std::max(room, 0.0)) - u;
}

/// Before somebody in the way. Who stands or walks ahead may turn and come, but need not: that
/// slows the robot down and does not stop it.
double careful_pace(const PaceConfig& config, Meeting m, bool stands) {
  if (m.coming > 0.0) return stopping_pace(config, m);
  const double as_it_is = stands ? config.max_speed : stopping_pace(config, m);
  m.coming = kSetsOff;
  return std::min(as_it_is, std::max(stopping_pace(config, m), kPassStanding));
}

}  // namespace

double passing_pace(const PaceConfig& config, const Lane& lane, double offset,
                    const std::vector<Mover>& movers) {
  double pace = config.max_speed;
  if ((lane.to - lane.from).norm() < 1e-6) return pace;
  for (const Mover& mover : movers) {
    const Meeting m = meeting(lane, mover);
    const bool behind = m.gap < std::min(kOvertaking * m.coming, 0.0);
    if (behind || m.gap > kFarAhead) continue;
    if (is_in_way(config, m, offset)) {
      pace = std::min(pace, careful_pace(config, m, mover.stands()));
    } else if (!mover.stands() && std::abs(m.across) < kBeside && -m.coming <= pace) {
      pace = std::min(pace, std::max(kPaceGain * (m.gap - kPaceGap), kSlowPace));
    }
  }
  return pace;
}

/// Room that is missing where movers are met, robot and mover keeping their ways.
double Passing::crowding(double offset, const Lane& lane, double speed,
                         const std::vector<Mover>& movers) const {
  const double wanted = config_.radius + kMoverRadius + config_.room;
  const Eigen::Vector2d along = (lane.to - lane.from).normalized();
  double missing = 0.0;
  for (const Mover& mover : movers) {
    if (mover.stands()) continue;  // What stands is driven around.
    const double gap = (mover.p - lane.from).dot(along);
    const double closing = speed - mover.velocity.dot(along);
    if (gap < -wanted || gap > config_.ahead || closing <= 0.05) continue;
    const double meeting = std::max(gap / closing, 0.0);
    if (meeting > kFarthest) continue;
    // People keep their side rather than their drift, which is known to 0.3 m/s at best.
    const Eigen::Vector2d p = mover.p + std::min(meeting, kDrift) * mover.velocity;
    const double across = (p - lane.from).dot(left_of(along));
    missing += std::max(wanted - std::abs(across - offset), 0.0);
  }
  return missing;
}

Eigen::Vector2d Passing::aside(const Lane& lane, double speed, const std::vector<Mover>& movers,
                               const FreeSpace& mapped) {
  const double length = (lane.to - lane.from).norm();
  if (length < kShortest) return lane.to;  // The lane's end is to be reached.
  const Eigen::Vector2d left = left_of((lane.to - lane.from) / length);
  const auto room = [&](double offset) {
    return mapped.clearance_at(lane.to + offset * left) - config_.radius;
  };
  const double own = room(-config_.right) > kEnough ? -config_.right : 0.0;
  const double pace = std::max(speed, kSlowestPassing);
  const bool minded =
      crowding(own, lane, pace, movers) > 0.0 || crowding(offset_, lane, pace, movers) > 0.0;
  const double change = minded ? kCrossCost : kChangeCost;
  double least = std::numeric_limits<double>::infinity();
  double chosen = 0.0;
  for (int i = -kPassingSteps; i <= kPassingSteps; ++i) {
    const double offset = kStep * i;
    if (i != 0 && room(offset) < kLeastRoom) continue;
    const double cost = kAsideCost * std::abs(offset - own) + change * std::abs(offset - offset_) +
                        kCrowdedCost * crowding(offset, lane, pace, movers);
    if (cost >= least) continue;
    least = cost;
    chosen = offset;
  }
  offset_ = chosen;
  return lane.to + chosen * left;
}

}  // namespace castaway::sim
