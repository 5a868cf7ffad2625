#include "sim/stages/world_stage.hpp"

#include <algorithm>
#include <utility>

#include "sim/common/seconds.hpp"
#include "sim/people/walk_space.hpp"
#include "sim/world/footprint.hpp"

namespace castaway::sim {
namespace {

constexpr std::chrono::nanoseconds kTryAgain = std::chrono::milliseconds(50);
constexpr double kCellsAround = 2.0;  // Erosion on a grid errs by up to this many cells.

}  // namespace

bool is_clear(const WorldObject& object, const Occupants& occupants, double resolution) {
  const ConvexOutline outline = footprint(object);
  const double around = kCellsAround * resolution;
  if (distance(outline, occupants.robot) < occupants.robot_radius + around) return false;
  return std::ranges::all_of(occupants.people, [&](const Eigen::Vector2d& p_map) {
    return distance(outline, p_map) >= WalkSpace::kBodyRoom + around;
  });
}

WorldStage::WorldStage(const WorldSpec& world, std::vector<WorldChange> changes)
    : waiting_(std::move(changes)) {
  std::ranges::stable_sort(waiting_, {}, &WorldChange::at_s);
  if (!waiting_.empty()) (void)world_after(world, waiting_);
}

void WorldStage::add(const WorldChange& change, const WorldSpec& world) {
  std::vector<WorldChange> planned = waiting_;
  planned.insert(std::ranges::upper_bound(planned, change.at_s, {}, &WorldChange::at_s), change);
  (void)world_after(world, planned);
  waiting_ = std::move(planned);
}

bool WorldStage::due(std::chrono::nanoseconds now) const {
  return !waiting_.empty() && now >= next_try_ && waiting_.front().at_s <= to_seconds(now);
}

void WorldStage::advance(std::chrono::nanoseconds now,
                         const std::function<bool(const WorldChange& change)>& make) {
  while (due(now)) {
    if (make(waiting_.front())) {
      waiting_.erase(waiting_.begin());
    } else {
      next_try_ = now + kTryAgain;
    }
  }
}

}  // namespace castaway::sim
