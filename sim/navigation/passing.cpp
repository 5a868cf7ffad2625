#include "sim/navigation/passing.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace castaway::sim {
namespace {

constexpr double kOffsetStep = 0.1;  // [m] Between the offsets tried.
constexpr int kPassingSteps = 9;     // Offsets tried on each side.
// Cost of each metre from the offset it would choose without people.
constexpr double kAsideCost = 0.3;
constexpr double kChangeCost = 0.1;  // Cost of each metre from the offset chosen last.
// The same while somebody comes: the robot then keeps its choice of side.
constexpr double kCrossCost = 0.6;
constexpr double kCrowdedCost = 4.0;  // Cost of each metre of room that is missing.
// [m/s] Least speed assumed for meetings, even while the robot stands.
constexpr double kSlowestPassing = 0.4;
// [s] A mover's motion across the lane is extrapolated for at most this long.
constexpr double kDrift = 0.4;
constexpr double kFarthest = 5.0;    // [s] Later meetings are ignored.
constexpr double kLeastRoom = 0.05;  // [m] Least room to mapped obstacles.
// [m] Room to mapped obstacles needed to keep right without people about.
constexpr double kKeepRightRoom = 0.2;
constexpr double kShortest = 0.8;  // [m] On shorter lanes the robot does not leave the lane.
// [m] People farther from the lane than this do not slow the robot down.
constexpr double kMaxLaneDistance = 1.2;
// [m] The pace beside a mover is kPaceGain * (gap - kPaceGap), but at least kSlowPace.
constexpr double kPaceGap = 1.5;
constexpr double kSlowPace = 0.2;       // [m/s]
constexpr double kPaceGain = 0.35;      // [1/s]
constexpr double kWayRoom = 0.15;       // [m] A mover that passes with less room is in the way.
constexpr double kDriftInWay = 1.0;     // [s] As `kDrift`, to tell whether a mover gets in the way.
constexpr double kReactionDelay = 0.5;  // [s] Delay until a scan is seen and acted upon.
constexpr double kFarAhead = 9.0;       // [m] People farther ahead are ignored.
// [m/s] Speed at which a person who stands or walks ahead may start to approach.
constexpr double kApproachSpeed = 1.2;
// [m/s] Least pace at which such people are passed, however near they are.
constexpr double kPassStanding = 0.3;
// [s] A person who overtakes counts from this long before drawing level.
constexpr double kOvertakingTime = 0.5;

Eigen::Vector2d left_of(const Eigen::Vector2d& along) { return {-along.y(), along.x()}; }

/// A mover in the coordinates of a lane.
struct Meeting {
  double gap;     ///< [m] Along the lane, ahead positive.
  double across;  ///< [m] Across the lane, left positive.
  double coming;  ///< [m/s] Along the lane, towards the robot positive.
  double aside;   ///< [m/s] Across the lane, to the left positive.
};

Meeting meeting(const Lane& lane, const Mover& mover) {
  const Eigen::Vector2d along = (lane.to - lane.from).normalized();
  const Eigen::Vector2d left = left_of(along);
  const Eigen::Vector2d p = mover.p - lane.from;
  return {p.dot(along), p.dot(left), -mover.velocity.dot(along), mover.velocity.dot(left)};
}

/// True if robot and mover come too near to each other when both keep their course.
bool is_in_way(const PaceConfig& config, const Meeting& m, double offset) {
  const double closing = std::max(m.coming + 0.5 * config.max_speed, kSlowestPassing);
  const double then = m.across + std::min(m.gap / closing, kDriftInWay) * m.aside;
  const double least = config.radius + kMoverRadius + kWayRoom;
  return std::min(std::abs(m.across - offset), std::abs(then - offset)) < least ||
         (m.across - offset) * (then - offset) < 0.0;
}

/// Speed from which the robot has stopped when a person who approaches reaches it:
/// v^2 / (2 a) + (v / a + kReactionDelay) coming = room.
double stopping_pace(const PaceConfig& config, const Meeting& m) {
  const double u = std::max(m.coming, 0.0);
  const double room = m.gap - config.radius - kMoverRadius - kWayRoom - kReactionDelay * u;
  const double a = config.deceleration;
  return std::sqrt(u * u + 2.0 * a * std::max(room, 0.0)) - u;
}

/// Pace towards a person in the way. A person who stands or walks ahead may turn and approach, but
/// need not: the robot slows down for that case without stopping.
double careful_pace(const PaceConfig& config, Meeting m, bool stands) {
  if (m.coming > 0.0) return stopping_pace(config, m);
  const double as_it_is = stands ? config.max_speed : stopping_pace(config, m);
  m.coming = kApproachSpeed;
  return std::min(as_it_is, std::max(stopping_pace(config, m), kPassStanding));
}

}  // namespace

double passing_pace(const PaceConfig& config, const Lane& lane, double offset,
                    const std::vector<Mover>& movers) {
  double pace = config.max_speed;
  if ((lane.to - lane.from).norm() < 1e-6) return pace;
  for (const Mover& mover : movers) {
    const Meeting m = meeting(lane, mover);
    const bool behind = m.gap < std::min(kOvertakingTime * m.coming, 0.0);
    if (behind || m.gap > kFarAhead) continue;
    if (is_in_way(config, m, offset)) {
      pace = std::min(pace, careful_pace(config, m, mover.stands()));
    } else if (!mover.stands() && std::abs(m.across) < kMaxLaneDistance && -m.coming <= pace) {
      pace = std::min(pace, std::max(kPaceGain * (m.gap - kPaceGap), kSlowPace));
    }
  }
  return pace;
}

/// Total room missing at the meetings with moving people when all keep their course. [m]
double Passing::missing_room(double offset, const Lane& lane, double speed,
                             const std::vector<Mover>& movers) const {
  const double wanted = config_.radius + kMoverRadius + config_.room;
  const Eigen::Vector2d along = (lane.to - lane.from).normalized();
  double missing = 0.0;
  for (const Mover& mover : movers) {
    if (mover.stands()) continue;  // Standing people are driven around by the local planner.
    const double gap = (mover.p - lane.from).dot(along);
    const double closing = speed - mover.velocity.dot(along);
    if (gap < -wanted || gap > config_.ahead || closing <= 0.05) continue;
    const double meeting = std::max(gap / closing, 0.0);
    if (meeting > kFarthest) continue;
    // People keep their side rather than their drift, whose estimate has an error of at least 0.3
    // m/s.
    const Eigen::Vector2d p = mover.p + std::min(meeting, kDrift) * mover.velocity;
    const double across = (p - lane.from).dot(left_of(along));
    missing += std::max(wanted - std::abs(across - offset), 0.0);
  }
  return missing;
}

Eigen::Vector2d Passing::choose_target(const Lane& lane, double speed,
                                       const std::vector<Mover>& movers, const FreeSpace& mapped) {
  const double length = (lane.to - lane.from).norm();
  if (length < kShortest) return lane.to;  // The lane's end must be reached.
  const Eigen::Vector2d left = left_of((lane.to - lane.from) / length);
  const auto room = [&](double offset) {
    return mapped.clearance_at(lane.to + offset * left) - config_.radius;
  };
  const double own = room(-config_.right) > kKeepRightRoom ? -config_.right : 0.0;
  const double pace = std::max(speed, kSlowestPassing);
  const bool meets_people = missing_room(own, lane, pace, movers) > 0.0 ||
                            missing_room(offset_, lane, pace, movers) > 0.0;
  const double change = meets_people ? kCrossCost : kChangeCost;
  double least = std::numeric_limits<double>::infinity();
  double chosen = 0.0;
  for (int i = -kPassingSteps; i <= kPassingSteps; ++i) {
    const double offset = kOffsetStep * i;
    if (i != 0 && room(offset) < kLeastRoom) continue;
    const double cost = kAsideCost * std::abs(offset - own) + change * std::abs(offset - offset_) +
                        kCrowdedCost * missing_room(offset, lane, pace, movers);
    if (cost >= least) continue;
    least = cost;
    chosen = offset;
  }
  offset_ = chosen;
  return lane.to + chosen * left;
}

}  // namespace castaway::sim
