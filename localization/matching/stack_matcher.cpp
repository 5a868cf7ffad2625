#include "localization/matching/stack_matcher.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "localization/map/cell_index.hpp"
#include "localization/space/stack/stacked_obstacles.hpp"

namespace castaway::localization {
namespace {

constexpr std::int64_t kWholeSlice = 1 << 20;  // [tiles] Any size gives the same result.
// Of the direction up: a class of slopes is half as wide, and the measurement errs.
constexpr double kTiltTolerance = 0.08;
constexpr float kLowestPoint = 0.12F;    // [m] Lower end points of a robot's scan are ground.
constexpr double kFarthestReach = 30.0;  // [m] Memory grows with its square.

StackConfig stack_config(const MatcherConfig& config) {
  validate(config);
  StackConfig stack;
  stack.resolution = config.field.resolution;
  stack.reach = std::min(config.field.padding, kFarthestReach);
  return stack;
}

ScanPoints above_ground(const ScanPoints& points) {
  std::vector<std::size_t> kept;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const bool on_ground = points.z[i] <= kLowestPoint || points.kind(i) == BeamKind::kFlat;
    if (!on_ground) kept.push_back(i);
  }
  return points_at(points, kept);
}

/// All cells, and each of the pyramids of the classes with its free cells.
std::vector<Pyramid> make_pyramids(const ByteField& field, const StackedGround& ground,
                                   int levels) {
  const Pyramid all = make_pyramid(field, levels);
  std::vector<Pyramid> pyramids;
  for (std::size_t slope = 0; slope < ground.slopes().size(); ++slope) {
    const auto free = ground.cells_of_slope(static_cast<std::uint16_t>(slope));
    Pyramid& pyramid = pyramids.emplace_back();
    for (const PooledField& level : all) pyramid.push_back(level.with_free(free));
  }
  return pyramids;
}

int score_at(const ByteField& field, const Eigen::Vector2i& cell,
             const std::vector<CellOffset>& offsets) {
  int sum = 0;
  for (const CellOffset& offset : offsets) {
    sum += *field.cell(cell.x() + offset.dx, cell.y() + offset.dy);
  }
  return sum;
}

}  // namespace

StackMatcher::StackMatcher(const MatcherConfig& config, const Volume& volume)
    : config_(config),
      volume_(volume),
      stack_(volume.atlas().ground(), stack_config(config)),
      ground_(volume.atlas(), stack_),
      field_(stack_.grid(), stack_.reach,
             stack_obstacles(volume.voxels(), volume.atlas().ground(), stack_, config.field.sigma),
             std::vector<bool>(stack_.grid().size(), true)),
      pyramids_(make_pyramids(field_, ground_, config.levels)) {}

std::vector<CellOffset> StackMatcher::offsets(const ScanPoints& points, std::uint16_t slope,
                                              int yaw) const {
  const Eigen::Matrix3d R_grid_base =
      orientation_on(ground_.slopes()[slope], yaw_of_step(yaw, yaw_steps(config_)));
  const Eigen::Vector3d cell(stack_.plane.resolution, stack_.plane.resolution, stack_.height);
  std::vector<CellOffset> offsets;
  for (const std::size_t i : even_indices(points.size(), config_.points)) {
    const Eigen::Vector3d p_base =
        Eigen::Vector3f(points.x[i], points.y[i], points.z[i]).cast<double>();
    const Eigen::Vector3d p = (R_grid_base * p_base).cwiseQuotient(cell).array() + 0.5;
    const int dx = cell_index(p.x());
    const int dy = cell_index(p.y());
    const int up = cell_index(p.z());
    if (Eigen::Vector2i(dx, dy).squaredNorm() >= stack_.reach * stack_.reach) continue;
    if (std::abs(up) <= stack_.reach_up) offsets.push_back({dx, dy + up * stack_.pitch});
  }
  return offsets;
}

bool StackMatcher::is_upright(const ScanPoints& points, std::uint16_t slope, int yaw) const {
  if (!points.up) return true;
  const Eigen::Vector3d up = up_on(ground_.slopes()[slope], yaw_of_step(yaw, yaw_steps(config_)));
  return (points.up->cast<double>() - up).norm() <= kTiltTolerance;
}

StagedSearch StackMatcher::search(const ScanPoints& points, const std::optional<int>& most,
                                  double least) const {
  const ScanPoints seen = above_ground(points);
  const SearchSpace space = search_space(field_.frame(), yaw_steps(config_), {});
  std::vector<SearchStage> stages;
  for (std::size_t slope = 0; slope < pyramids_.size(); ++slope) {
    const auto number = static_cast<std::uint16_t>(slope);
    SearchStage stage{&pyramids_[slope], space, {}};
    std::erase_if(stage.space.yaws, [&](int yaw) { return !is_upright(points, number, yaw); });
    for (const int yaw : stage.space.yaws) stage.scans.push_back(offsets(seen, number, yaw));
    if (!stage.scans.empty()) stages.push_back(std::move(stage));
  }
  const double perfect = perfect_score(config_, seen.size());
  const auto least_sum = static_cast<int>(std::ceil(least * perfect));
  return {std::move(stages),
          make_best_places(config_, field_.frame(), most.value_or(config_.candidates), least_sum),
          perfect};
}

std::vector<Candidate> StackMatcher::match(const ScanPoints& points,
                                           const std::optional<MatchWindow>& window,
                                           const std::optional<int>& most) const {
  const ScanPoints seen = above_ground(points);
  if (seen.empty()) return {};
  if (window) return match_within(seen, *window, most.value_or(config_.candidates));
  StagedSearch whole = search(points, most);
  while (!whole.complete()) whole.step(kWholeSlice);
  return candidates(whole);
}

/// Cells with ground within a window; each once.
std::vector<GroundCell> StackMatcher::cells_within(const MatchWindow& window) const {
  const GridFrame& frame = volume_.atlas().frame();
  const Eigen::Vector2d centre = frame.T_map_grid.inverse() * window.centre.translation();
  const Eigen::Vector2i low = frame.cell_of(centre.array() - window.radius).cwiseMax(0);
  const Eigen::Vector2i high = frame.cell_of(centre.array() + window.radius);
  std::vector<GroundCell> cells;
  for (int row = low.y(); row <= std::min(high.y(), frame.height - 1); row += stack_.factor) {
    for (int column = low.x(); column <= std::min(high.x(), frame.width - 1);
         column += stack_.factor) {
      if (const auto cell = ground_.cell_of({column, row})) cells.push_back(*cell);
    }
  }
  return cells;
}

/// All places of a window are scored: there are few.
std::vector<Candidate> StackMatcher::match_within(const ScanPoints& points,
                                                  const MatchWindow& window, int most) const {
  BestPlaces best = make_best_places(config_, field_.frame(), most);
  const std::vector<GroundCell> cells = cells_within(window);
  const SearchSpace space = search_space(field_.frame(), yaw_steps(config_), window);
  for (const int yaw : space.yaws) {
    std::map<std::uint16_t, std::vector<CellOffset>> scans;
    for (const GroundCell& at : cells) {
      auto [scan, is_new] = scans.try_emplace(at.slope);
      if (is_new) scan->second = offsets(points, at.slope, yaw);
      if (!is_upright(points, at.slope, yaw)) continue;
      best.offer({at.cell.x(), at.cell.y(), yaw, score_at(field_, at.cell, scan->second)});
    }
  }
  return candidates(best, perfect_score(config_, points.size()));
}

std::vector<Candidate> StackMatcher::candidates(const StagedSearch& search) const {
  return candidates(search.best(), search.perfect());
}

std::vector<Candidate> StackMatcher::candidates(const BestPlaces& best, double perfect) const {
  std::vector<Candidate> candidates;
  for (const Place& place : best.list()) {
    const double yaw = wrap_angle(yaw_of_step(place.yaw, yaw_steps(config_)));
    candidates.push_back({ground_.pose_at({place.column, place.row}, yaw), place.score / perfect});
  }
  return candidates;
}

}  // namespace castaway::localization
