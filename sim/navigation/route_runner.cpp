#include "sim/navigation/route_runner.hpp"

#include <utility>

#include "sim/navigation/planner.hpp"

namespace castaway::sim {
namespace {

// [m] A path that ends farther from its waypoint did not reach it.
constexpr double kReached = 0.2;

}  // namespace

RouteRunner::RouteRunner(RouteConfig config, FreeSpace free)
    : config_(std::move(config)), free_(std::move(free)) {}

void RouteRunner::next_waypoint() {
  const double beside = (follower_->path().back() - config_.waypoints[waypoint_]).norm();
  passed_ += beside <= kReached ? 1 : 0;
  follower_.reset();
  detour_.reset();
  ++waypoint_;
  if (config_.loop && waypoint_ >= config_.waypoints.size()) waypoint_ = 0;
}

void RouteRunner::plan(const Pose2& T_map_base) {
  auto path = plan_path(free_, T_map_base.position(), config_.waypoints[waypoint_]);
  if (path) follower_.emplace(config_.follower, std::move(*path));
}

Twist2 RouteRunner::command(const std::optional<Pose2>& T_map_base) {
  if (!T_map_base || waypoint_ >= config_.waypoints.size()) return {};
  const bool off = follower_ && follower_->off_path(*T_map_base) > config_.replan_distance;
  if (off) detour_.reset();
  if (!follower_ || off) plan(*T_map_base);
  if (!follower_) return {};
  const Twist2 twist = follower_->command(*T_map_base, detour_ ? *detour_ : free_);
  if (follower_->has_arrived(*T_map_base)) next_waypoint();
  return twist;
}

void RouteRunner::detour(const Pose2& T_map_base, FreeSpace free) {
  if (waypoint_ >= config_.waypoints.size()) return;
  auto path = plan_path(free, T_map_base.position(), config_.waypoints[waypoint_]);
  if (!path || (path->front() - T_map_base.position()).norm() > config_.replan_distance) return;
  follower_.emplace(config_.follower, std::move(*path));
  detour_ = std::move(free);
}

void RouteRunner::set_free(FreeSpace free) {
  free_ = std::move(free);
  detour_.reset();
  follower_.reset();
}

std::vector<Eigen::Vector2d> RouteRunner::path() const {
  return follower_ ? follower_->path() : std::vector<Eigen::Vector2d>{};
}

}  // namespace castaway::sim
