#include "sim/navigation/people_guard.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace castaway::sim {

PeopleGuard::PeopleGuard(const GuardConfig& config, double person_radius)
    : config_(config), reach_(config.radius + person_radius) {}

Twist2 PeopleGuard::limit(const Twist2& command, const std::vector<Eigen::Vector2d>& p_base) {
  double gap = std::numeric_limits<double>::infinity();
  for (const Eigen::Vector2d& p : p_base) {
    if (p.x() <= 0.0 || std::abs(p.y()) >= reach_) continue;
    gap = std::min(gap, p.x() - std::sqrt(reach_ * reach_ - p.y() * p.y()));
  }
  const double room = gap - config_.margin;
  const double allowed = room > 0.0 ? std::sqrt(2.0 * config_.deceleration * room) : 0.0;
  if (command.v <= allowed) {
    waiting_ = 0;
    return command;
  }
  waiting_ = allowed > 0.0 ? 0 : waiting_ + 1;
  return {allowed, command.w * allowed / command.v};
}

bool PeopleGuard::has_waited(int calls) {
  if (waiting_ < calls) return false;
  waiting_ = 0;
  return true;
}

}  // namespace castaway::sim
