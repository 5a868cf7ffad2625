#include "localization/matching/cascade_matcher.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "localization/matching/scan_shifts.hpp"
#include "localization/matching/tiles.hpp"

namespace castaway::localization {
namespace {

constexpr int kByteMax = 255;
constexpr std::int64_t kSlice = 1 << 20;  // [tiles] Any size gives the same result.

}  // namespace

void score_all(const PooledField& cells, const SearchSpace& space,
               const std::vector<std::vector<CellOffset>>& scans, BestPlaces& best) {
  ScanShifts shifts(1, scans);
  std::vector<Tile> tiles = tiles_within(cells, space);
  for (std::size_t yaw = 0; yaw < space.yaws.size(); ++yaw) {
    for (Tile& tile : tiles) {
      tile.yaw = static_cast<int>(yaw);
      offer_tile(cells, space, tile,
                 tile_sums(cells, tile, shifts.at(cells.layout(), yaw), best.threshold()).sums,
                 best);
    }
  }
}

void validate(const MatcherConfig& config) {
  if (config.points < 1 || config.points > 256) {
    throw std::invalid_argument("matcher points must be in 1..256");
  }
  if (!(config.yaw_step > 0.0)) throw std::invalid_argument("matcher yaw_step must be positive");
  if (config.candidates < 1) throw std::invalid_argument("matcher candidates must be at least 1");
  if (config.levels < 1 || config.levels > 6) {
    throw std::invalid_argument("matcher levels must be in 1..6");
  }
}

int yaw_steps(const MatcherConfig& config) {
  return std::max(1, static_cast<int>(std::lround(2.0 * std::numbers::pi / config.yaw_step)));
}

double perfect_score(const MatcherConfig& config, std::size_t points) {
  return kByteMax * std::min<double>(config.points, static_cast<double>(points));
}

BestPlaces make_best_places(const MatcherConfig& config, const GridFrame& frame, int most,
                            int least) {
  const double yaws_per_radian = yaw_steps(config) / (2.0 * std::numbers::pi);
  const BinSize bin{
      std::max(1, static_cast<int>(config.suppression_m / frame.resolution)),
      std::max(1, static_cast<int>(std::lround(config.suppression_rad * yaws_per_radian)))};
  return {frame, bin, most, kByteMax * config.points, least};
}

CascadeMatcher::CascadeMatcher(const MatcherConfig& config, const OccupancyGrid& grid,
                               const DistanceField& distances)
    : config_((validate(config), config)),
      field_(grid, distances, config.field),
      pyramid_(make_pyramid(field_, config.levels)),
      yaws_(yaw_steps(config)) {}

std::vector<std::vector<CellOffset>> CascadeMatcher::rotate_scans(const ScanPoints& points,
                                                                  const SearchSpace& space) const {
  std::vector<std::vector<CellOffset>> scans;
  for (const int yaw : space.yaws) {
    scans.push_back(rotate_scan(points, config_.points, field_.frame().resolution,
                                yaw_of_step(yaw, yaws_), field_.padding()));
  }
  return scans;
}

StagedSearch CascadeMatcher::search(const ScanPoints& points, const std::optional<int>& most,
                                    double least) const {
  return search_within(points, {}, most, least);
}

StagedSearch CascadeMatcher::search_within(const ScanPoints& points,
                                           const std::optional<MatchWindow>& window,
                                           const std::optional<int>& most, double least) const {
  const SearchSpace space = search_space(field_.frame(), yaws_, window);
  const double perfect = perfect_score(config_, points.size());
  return {{{&pyramid_, space, rotate_scans(points, space)}},
          make_best_places(config_, field_.frame(), most.value_or(config_.candidates),
                           static_cast<int>(std::ceil(least * perfect))),
          perfect};
}

std::vector<Candidate> CascadeMatcher::match(const ScanPoints& points,
                                             const std::optional<MatchWindow>& window,
                                             const std::optional<int>& most) const {
  if (points.empty()) return {};
  if (!window && config_.algorithm == MatchAlgorithm::kBranchAndBound) {
    StagedSearch whole = search(points, most);
    while (!whole.complete()) whole.step(kSlice);
    return candidates(whole);
  }
  BestPlaces best = make_best_places(config_, field_.frame(), most.value_or(config_.candidates));
  const SearchSpace space = search_space(field_.frame(), yaws_, window);
  score_all(pyramid_.front(), space, rotate_scans(points, space), best);
  return candidates(best, perfect_score(config_, points.size()));
}

std::vector<Candidate> CascadeMatcher::candidates(const StagedSearch& search) const {
  return candidates(search.best(), search.perfect());
}

std::vector<Candidate> CascadeMatcher::candidates(const BestPlaces& best, double perfect) const {
  const GridFrame& frame = field_.frame();
  std::vector<Candidate> candidates;
  for (const Place& place : best.list()) {
    const Eigen::Vector2d p = frame.centre_of({place.column, place.row});
    const SE2 T_grid_base{p.x(), p.y(), wrap_angle(yaw_of_step(place.yaw, yaws_))};
    candidates.push_back({frame.T_map_grid * T_grid_base, place.score / perfect});
  }
  return candidates;
}

}  // namespace castaway::localization
