#include "tools/twin/odometry/stretch.hpp"

#include <cmath>
#include <utility>

namespace castaway::testbed {
namespace {

/// Sets how far errors of the distance and of the yaw on the way move the end.
void weigh_travel(Stretch& stretch) {
  const SE2 end = correct_motion(stretch.steps, {});
  SE2 pose;
  for (const OdometryStep& step : stretch.steps) {
    pose = pose * correct_motion({step}, {});
    const SE2 T_end_step = end.inverse() * pose;
    const Eigen::Vector2d heading(std::cos(T_end_step.yaw), std::sin(T_end_step.yaw));
    const Eigen::Vector2d lever(T_end_step.y, T_end_step.x);
    stretch.turn += std::abs(step.turn);
    stretch.walk += step.way * heading.cwiseAbs2();
    stretch.sway += step.way * lever.cwiseAbs2();
    stretch.swing += std::abs(step.turn) * lever.cwiseAbs2();
  }
}

/// Sets how far errors of the pose and of the stamps at both ends move the end.
void weigh_ends(const OdometryRate& start, const OdometryRate& end, Stretch& stretch) {
  const SE2 T_end_start = stretch.T_start_end.inverse();
  const Eigen::Vector2d heading(std::cos(T_end_start.yaw), std::sin(T_end_start.yaw));
  const Eigen::Vector2d lever(T_end_start.y, -T_end_start.x);
  stretch.lever = lever.cwiseAbs2();
  stretch.speeds = (start.along * heading + start.turn * lever).cwiseAbs2() +
                   end.along * end.along * Eigen::Vector2d::UnitX();
  stretch.turn_rates = start.turn * start.turn + end.turn * end.turn;
}

}  // namespace

std::vector<Stretch> take_stretches(const std::vector<Leg>& legs, double length) {
  constexpr double kMuchLonger = 3.0;
  std::vector<Stretch> stretches;
  Stretch now;
  for (std::size_t i = 0; i < legs.size(); ++i) {
    if (legs[i].breaks) {
      now = {};
      continue;
    }
    if (now.steps.empty()) now.leg = i;
    now.steps.insert(now.steps.end(), legs[i].steps.begin(), legs[i].steps.end());
    now.T_start_end = now.T_start_end * legs[i].T_start_end;
    now.way += legs[i].way;
    if (now.way < length) continue;
    if (now.way < kMuchLonger * length) {
      weigh_travel(now);
      weigh_ends(legs[now.leg].rate_at_start, legs[i].rate_at_end, now);
      stretches.push_back(std::move(now));
    }
    now = {};
  }
  return stretches;
}

SE2 miss_of(const Stretch& stretch, const DriveErrors& errors) {
  return stretch.T_start_end.inverse() * correct_base_motion(stretch.steps, errors);
}

}  // namespace castaway::testbed
