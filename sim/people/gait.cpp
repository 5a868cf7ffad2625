#include "sim/people/gait.hpp"

#include <algorithm>
#include <cmath>

namespace castaway::sim {
namespace {

constexpr double kWalkRatio = 0.0062;  // [m min] Step length per steps a minute.
// [m/s] A slower person takes steps only to bring its feet beside each other.
constexpr double kStandingSpeed = 0.1;
// [m] A standing person moves a foot that is farther than this from its place.
constexpr double kFootTolerance = 0.08;
constexpr double kSettleRate = 0.9;  // [Hz] Gait cycles while a standing person moves its feet.
// [m] A foot farther from the body than this is put back: somebody else moved the body.
constexpr double kMaxLegReach = 1.2;
constexpr double kFootRoom = 0.1;  // [m] Least distance from the middle of a foot to a wall.

Eigen::Vector2d beside(const PersonState& state, std::size_t foot) {
  const Eigen::Vector2d ahead = heading_vector(state.heading);
  const double side = foot == 0 ? kFootSpread : -kFootSpread;
  return side * Eigen::Vector2d(-ahead.y(), ahead.x());
}

bool must_step(const PersonState& state) {
  for (std::size_t foot = 0; foot < 2; ++foot) {
    const Eigen::Vector2d home = state.position + beside(state, foot);
    if ((state.feet[foot] - home).norm() > kFootTolerance) return true;
  }
  return false;
}

double cycles_per_second(const PersonState& state) {
  const double speed = state.velocity.norm();
  if (speed > kStandingSpeed) return speed / (2.0 * step_length(speed));
  return must_step(state) ? kSettleRate : 0.0;
}

/// The point at `offset` from the body, moved towards the body until a foot there is off the walls.
Eigen::Vector2d with_room(const WalkSpace& space, const PersonState& state,
                          const Eigen::Vector2d& offset) {
  for (const double share : {1.0, 0.75, 0.5, 0.25}) {
    Eigen::Vector2d foot = state.position + share * offset;
    if (space.wall(foot).distance >= kFootRoom) return foot;
  }
  return state.position;
}

/// Moves the swinging foot towards where it will land, by `share` of the remaining way.
void swing(const WalkSpace& space, std::size_t foot, double left, double dt, double share,
           PersonState& state) {
  const double speed = state.velocity.norm();
  Eigen::Vector2d offset = beside(state, foot);
  if (speed > kStandingSpeed) {
    const Eigen::Vector2d ahead = state.velocity / speed;
    offset += ahead * (speed * std::max(left - dt, 0.0) + 0.5 * step_length(speed));
  }
  const Eigen::Vector2d target = with_room(space, state, offset);
  state.feet[foot] += share * (target - state.feet[foot]);
}

}  // namespace

double step_length(double speed) { return std::sqrt(60.0 * kWalkRatio * speed); }

void stand(PersonState& state) {
  for (std::size_t foot = 0; foot < 2; ++foot) {
    state.feet[foot] = state.position + beside(state, foot);
  }
}

void walk(const WalkSpace& space, const PersonState& before, double dt, PersonState& state) {
  state.feet = before.feet;
  state.gait_phase = before.gait_phase;
  for (const Eigen::Vector2d& foot : state.feet) {
    if ((foot - state.position).norm() > kMaxLegReach) return stand(state);
  }
  const double rate = cycles_per_second(state);
  if (rate == 0.0) return;
  const bool left_planted = before.gait_phase < 0.5;
  const double end = left_planted ? 0.5 : 1.0;
  const double left = (end - before.gait_phase) / rate;  // [s] Until the swinging foot lands.
  swing(space, left_planted ? 1 : 0, left, dt, std::min(dt / left, 1.0), state);
  state.gait_phase = std::min(before.gait_phase + rate * dt, end);
  if (state.gait_phase >= 1.0) state.gait_phase = 0.0;
}

}  // namespace castaway::sim
