#include "sim/events/level_target.hpp"

#include <limits>
#include <stdexcept>

#include <fmt/format.h>
#include <boost/random/uniform_int_distribution.hpp>

#include "sim/map/level_plane.hpp"

namespace castaway::sim {
namespace {

constexpr double kRampSlope = 0.05;  // Rise per metre; steeper ground is a ramp.

int level_at(const LevelPlane& plane, const Pose2& T_plane_base) {
  const LevelCell* cell = plane.at(T_plane_base.position());
  return cell != nullptr ? cell->level : 0;
}

/// Calls `use` with a pose in the centre of each free cell.
template <typename Use>
void for_each_free(const FreeSpace& free, const Use& use) {
  const Grid& grid = free.grid();
  for (std::size_t i = 0; i < grid.cells.size(); ++i) {
    if (grid.cells[i] != Cell::kFree) continue;
    const Eigen::Vector2d p = center_of(grid, cell_at_index(grid, i));
    use(Pose2{p.x(), p.y(), 0.0});
  }
}

/// Another level than `level`, drawn; `level` itself if it is the only one.
int drawn_level(const LevelPlane& plane, int level, Rng& rng) {
  if (plane.levels < 2) return level;
  const int drawn = boost::random::uniform_int_distribution<int>(0, plane.levels - 2)(rng);
  return drawn < level ? drawn : drawn + 1;
}

}  // namespace

bool is_wanted_ground(const KidnapSpec& spec, const FreeSpace& free, const Pose2& T_plane_base) {
  const LevelPlane* plane = free.levels();
  if (plane == nullptr) return true;
  if (spec.ramp && plane->slope_at(T_plane_base.position()) < kRampSlope) return false;
  return !spec.level || *spec.level == level_at(*plane, T_plane_base);
}

bool is_far_enough(const KidnapSpec& spec, const FreeSpace& free, const Pose2& T_plane_from,
                   const Pose2& T_plane_to) {
  const LevelPlane* plane = free.levels();
  if (plane == nullptr || level_at(*plane, T_plane_from) != level_at(*plane, T_plane_to)) {
    return true;  // Without floors, places that are too near are not drawn.
  }
  const Eigen::Vector2d way =
      plane->in_map(T_plane_to).position() - plane->in_map(T_plane_from).position();
  return way.norm() >= spec.min_distance_m;
}

std::optional<Pose2> elevator_target(const KidnapSpec& spec, const FreeSpace& free,
                                     const Pose2& T_plane_base, Rng& rng) {
  const LevelPlane* plane = free.levels();
  if (plane == nullptr) return std::nullopt;
  KidnapSpec there = spec;
  if (!there.level) there.level = drawn_level(*plane, level_at(*plane, T_plane_base), rng);
  const Eigen::Vector2d p_map = plane->in_map(T_plane_base).position();
  std::optional<Pose2> best;
  double least = std::numeric_limits<double>::infinity();
  for_each_free(free, [&](const Pose2& place) {
    const bool ramp = plane->slope_at(place.position()) >= kRampSlope;
    if (ramp || !is_wanted_ground(there, free, place)) return;
    const double away = (plane->in_map(place).position() - p_map).norm();
    if (away >= least) return;
    least = away;
    best = Pose2{place.x, place.y, T_plane_base.yaw};
  });
  return best;
}

std::optional<Pose2> target_on_plane(const KidnapSpec& spec, const LevelPlane* levels) {
  if (levels == nullptr || !spec.target) return spec.target;
  return levels->on_level(*spec.target, spec.level);
}

void require_wanted_ground(const KidnapSpec& spec, const FreeSpace& free) {
  const bool elevator = spec.kind == KidnapKind::kElevator;
  if (!spec.level && !spec.ramp && !elevator) return;
  if (free.levels() == nullptr) {
    throw std::runtime_error(
        fmt::format("kidnap {}: {} a world with `levels: true`", describe(spec.when),
                    elevator ? "an elevator needs" : "`level` and `ramp` need"));
  }
  if (elevator && free.levels()->levels < 2) {
    throw std::runtime_error(
        fmt::format("kidnap {}: an elevator needs a second level", describe(spec.when)));
  }
  bool found = false;
  for_each_free(free,
                [&](const Pose2& place) { found = found || is_wanted_ground(spec, free, place); });
  if (found) return;
  throw std::runtime_error(fmt::format("kidnap {}: no free place{}{}; the world has levels 0 to {}",
                                       describe(spec.when),
                                       spec.level ? fmt::format(" on level {}", *spec.level) : "",
                                       spec.ramp ? " on a ramp" : "", free.levels()->levels - 1));
}

}  // namespace castaway::sim
