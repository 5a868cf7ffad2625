#include "sim/events/kidnap_target.hpp"

#include <algorithm>
#include <cassert>
#include <numbers>
#include <stdexcept>

#include <fmt/format.h>
#include <boost/random/bernoulli_distribution.hpp>

#include "sim/events/level_target.hpp"
#include "sim/events/look_alike.hpp"
#include "sim/map/free_space.hpp"

namespace castaway::sim {
namespace {

constexpr int kDraws = 200;  // Attempts to find a place clear of people, or a free way for a push.
constexpr double kNudgeYaw = 0.3;  // [rad] Largest turn of a push.

using Found = std::optional<KidnapTarget>;

bool is_clear(const KidnapScene& scene, const Pose2& T_map_base) {
  return std::none_of(scene.people.begin(), scene.people.end(), [&](const Eigen::Vector2d& p_map) {
    return (p_map - T_map_base.position()).norm() < scene.keep_clear;
  });
}

/// `pose` if no person is in the way.
Found unless_occupied(const KidnapScene& scene, const Pose2& pose) {
  return is_clear(scene, pose) ? Found{{pose}} : std::nullopt;
}

/// The farthest place that is clear of people; used where no place is far enough away.
Found farthest_target(const KidnapSpec& spec, const KidnapScene& scene, Rng& rng) {
  const Grid& grid = scene.free.grid();
  const Eigen::Vector2d from = scene.T_map_base.position();
  std::optional<Pose2> best;
  bool any = false;
  for (int row = 0; row < grid.height; ++row) {
    for (int column = 0; column < grid.width; ++column) {
      if (grid.at(column, row) != Cell::kFree) continue;
      any = true;
      const Eigen::Vector2d p = center_of(grid, {column, row});
      if (best && (p - from).norm() <= (best->position() - from).norm()) continue;
      const Pose2 place{p.x(), p.y(), 0.0};
      const bool wanted = is_wanted_ground(spec, scene.free, place);
      if (wanted && is_clear(scene, place)) best = Pose2{p.x(), p.y(), 0.0};
    }
  }
  if (!any) {
    throw std::runtime_error(fmt::format(
        "kidnap {}: no free place for a robot of radius {:.2f} m: lower margin_m, or check the map",
        describe(spec.when), scene.free.radius()));
  }
  if (!best) return std::nullopt;
  best->yaw = draw_between(-std::numbers::pi, std::numbers::pi, rng);
  return Found{{*best, {}, true}};
}

Found given_target(const KidnapSpec& spec, const KidnapScene& scene) {
  const std::optional<Pose2> target = target_on_plane(spec, scene.free.levels());
  if (!target || !scene.free.contains(target->position())) {
    throw std::runtime_error(fmt::format(
        "kidnap {}: target ({}, {}) is nearer than {:.2f} m to an obstacle, or cut off from the "
        "free space: choose another",
        describe(spec.when), spec.target->x, spec.target->y, scene.free.radius()));
  }
  return unless_occupied(scene, *target);
}

Found random_target(const KidnapSpec& spec, const KidnapScene& scene, Rng& rng) {
  for (int i = 0; i < kDraws; ++i) {
    const auto pose = scene.free.sample(rng, scene.T_map_base.position(), spec.min_distance_m);
    if (!pose) return farthest_target(spec, scene, rng);
    const bool wanted = is_wanted_ground(spec, scene.free, *pose) &&
                        is_far_enough(spec, scene.free, scene.T_map_base, *pose);
    if (wanted && is_clear(scene, *pose)) return Found{{*pose}};
  }
  return std::nullopt;
}

Found look_alike_target(const KidnapSpec& spec, const KidnapScene& scene, Rng& rng) {
  assert(scene.look_alikes != nullptr);
  const auto twin = scene.look_alikes->most_alike(scene.T_map_base, spec.min_distance_m);
  if (!twin) return farthest_target(spec, scene, rng);
  if (!is_clear(scene, twin->T_map_base)) return std::nullopt;
  return Found{{twin->T_map_base, twin->unlikeness}};
}

Found nudge_target(const KidnapSpec& spec, const KidnapScene& scene, Rng& rng) {
  const Pose2& from = scene.T_map_base;
  for (int i = 0; i < kDraws; ++i) {
    const double angle = draw_between(-std::numbers::pi, std::numbers::pi, rng);
    const double way = draw_between(spec.nudge.min, spec.nudge.max, rng);
    const double turn = draw_between(-kNudgeYaw, kNudgeYaw, rng);
    const Pose2 to{from.x + way * std::cos(angle), from.y + way * std::sin(angle),
                   wrap_angle(from.yaw + turn)};
    const bool through = scene.free.contains_segment(from.position(), to.position());
    if (through && is_clear(scene, to)) return Found{{to}};
  }
  return std::nullopt;
}

Found turn_target(const KidnapSpec& spec, const KidnapScene& scene, Rng& rng) {
  Pose2 to = scene.T_map_base;
  if (!scene.free.contains(to.position())) return std::nullopt;
  const double side = boost::random::bernoulli_distribution<double>(0.5)(rng) ? 1.0 : -1.0;
  to.yaw = wrap_angle(to.yaw + side * draw_between(spec.turn.min, spec.turn.max, rng));
  return Found{{to}};
}

}  // namespace

std::optional<KidnapTarget> kidnap_target(const KidnapSpec& spec, const KidnapScene& scene,
                                          Rng& rng) {
  switch (spec.kind) {
    case KidnapKind::kTeleportTo:
      return given_target(spec, scene);
    case KidnapKind::kLookAlike:
      return look_alike_target(spec, scene, rng);
    case KidnapKind::kNudge:
      return nudge_target(spec, scene, rng);
    case KidnapKind::kTurn:
      return turn_target(spec, scene, rng);
    case KidnapKind::kSpin:
      return Found{{scene.T_map_base}};
    case KidnapKind::kElevator: {
      const auto place = elevator_target(spec, scene.free, scene.T_map_base, rng);
      return place ? Found{{*place}} : std::nullopt;
    }
    case KidnapKind::kCarry:
    case KidnapKind::kPalletTruck:
      return spec.target ? given_target(spec, scene) : random_target(spec, scene, rng);
    default:
      return random_target(spec, scene, rng);
  }
}

}  // namespace castaway::sim
