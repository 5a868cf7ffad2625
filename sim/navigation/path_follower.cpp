#include "sim/navigation/path_follower.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace castaway::sim {
namespace {

constexpr double kTurnGain = 2.0;         // [1/s] Turn rate per heading error, turning in place.
constexpr double kSearchAhead = 1.0;      // [m] Length of path searched for the nearest point.
constexpr double kFollowerBraking = 0.7;  // Share of the acceleration limit.

}  // namespace

PathFollower::PathFollower(const FollowerConfig& config, std::vector<Eigen::Vector2d> path)
    : config_(config), path_(std::move(path)) {
  assert(!path_.empty());
  way_to_end_.assign(path_.size(), 0.0);
  for (std::size_t i = path_.size() - 1; i > 0; --i) {
    way_to_end_[i - 1] = way_to_end_[i] + (path_[i] - path_[i - 1]).norm();
  }
}

void PathFollower::advance(const Eigen::Vector2d& p_map) {
  double way = 0.0;
  double best = (path_[nearest_] - p_map).norm();
  for (std::size_t i = nearest_ + 1; i < path_.size() && way < kSearchAhead; ++i) {
    way += (path_[i] - path_[i - 1]).norm();
    const double distance = (path_[i] - p_map).norm();
    if (distance > best) continue;
    best = distance;
    nearest_ = i;
  }
}

Eigen::Vector2d PathFollower::target(const Eigen::Vector2d& p_map, const FreeSpace& free) const {
  Eigen::Vector2d best = path_[std::min(nearest_ + 1, path_.size() - 1)];
  for (std::size_t i = nearest_ + 1; i < path_.size(); ++i) {
    if ((path_[i] - p_map).norm() > config_.lookahead) break;
    if (!free.contains_segment(p_map, path_[i])) break;
    best = path_[i];
  }
  return best;
}

Twist2 PathFollower::command(const Pose2& T_map_base, const FreeSpace& free) {
  const Eigen::Vector2d p_map = T_map_base.position();
  advance(p_map);
  if (has_arrived(T_map_base)) return {};
  aim_ = target(p_map, free);
  const Eigen::Vector2d p_base = inverse(T_map_base) * *aim_;
  const double error = std::atan2(p_base.y(), p_base.x());
  turning_ = std::abs(error) > (turning_ ? config_.turn_until : config_.turn_above);
  const double max_turn = config_.limits.max_turn_rate;
  if (turning_) return {0.0, std::clamp(kTurnGain * error, -max_turn, max_turn)};
  const double curvature = 2.0 * std::sin(error) / std::max(p_base.norm(), 0.05);
  const double braking = kFollowerBraking * config_.limits.max_acceleration;
  const double way = std::max(way_to_end_[nearest_], (path_.back() - p_map).norm());
  double v = std::min(config_.limits.max_speed, std::sqrt(2.0 * braking * way));
  v *= std::max(std::cos(error), 0.2);
  if (std::abs(curvature) * v > max_turn) v = max_turn / std::abs(curvature);
  return {v, curvature * v};
}

bool PathFollower::has_arrived(const Pose2& T_map_base) const {
  return (path_.back() - T_map_base.position()).norm() < config_.goal_tolerance;
}

double PathFollower::off_path(const Pose2& T_map_base) const {
  return (path_[nearest_] - T_map_base.position()).norm();
}

}  // namespace castaway::sim
