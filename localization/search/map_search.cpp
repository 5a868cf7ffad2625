#include "localization/search/map_search.hpp"

namespace castaway::localization {
namespace {

ScanPoints points_of(const CreateConfig& config, const ScanPoints& points, SearchDepth depth) {
  const bool by_far = config.far_share > 0.0 && depth == SearchDepth::kDeep;
  return by_far ? farthest_points(points, config.far_share) : points;
}

}  // namespace

MapSearch::MapSearch(const CreateConfig& config, const CascadeMatcher& matcher,
                     const ScanPoints& points, const SE2& T_odom_base, SearchDepth depth)
    : MapSearch(matcher, points_of(config, points, depth), T_odom_base,
                depth == SearchDepth::kDeep ? config.deep_candidates : config.quick_candidates,
                0.0) {}

MapSearch::MapSearch(const CascadeMatcher& matcher, const ScanPoints& points,
                     const SE2& T_odom_base, int most, double least)
    : matcher_(&matcher), T_odom_base_(T_odom_base), points_(points.size()) {
  if (!points.empty()) search_ = matcher.search(points, {}, most, least);
}

bool MapSearch::step(std::int64_t tiles, WorkBudget& budget) {
  if (!search_) return true;
  const std::int64_t before = search_->tiles_scored();
  const bool complete = search_->step(budget.grant(tiles));
  budget.spend(search_->tiles_scored() - before);
  return complete;
}

std::vector<Candidate> MapSearch::candidates(const SE2& T_odom_base) const {
  if (!search_) return {};
  const SE2 u = T_odom_base_.inverse() * T_odom_base;
  std::vector<Candidate> all = matcher_->candidates(search_->best(), points_);
  if (u == SE2{}) return all;
  for (Candidate& candidate : all) candidate.T_map_base = candidate.T_map_base * u;
  return all;
}

std::vector<WeighedPlace> refine_found(const CreateContext& context, const MapSearch& search,
                                       const ScanPoints& points, const SE2& T_odom_base, int most,
                                       WorkBudget& budget) {
  constexpr std::int64_t kTilesPerCandidate = 40;  // Estimates: to screen, and to refine.
  constexpr std::int64_t kTilesPerPlace = 500;
  std::vector<Candidate> found = search.candidates(T_odom_base);
  const auto listed = static_cast<std::int64_t>(found.size());
  found = screen_candidates(context, std::move(found), points, most);
  const auto refined = static_cast<std::int64_t>(found.size());
  budget.spend(kTilesPerCandidate * listed + kTilesPerPlace * refined);
  return refine_candidates(context, found, points);
}

std::optional<std::vector<WeighedPlace>> PlaceSearch::step(const CreateContext& context,
                                                           const ScanPoints& points,
                                                           const SE2& T_odom_base,
                                                           std::int64_t slice, WorkBudget& budget) {
  if (!search_) {
    CreateConfig config = context.config;
    if (depth_ == SearchDepth::kDeep) config.deep_candidates = deep_candidates_;
    search_.emplace(config, matcher_, points, T_odom_base, depth_);
  }
  if (!search_->step(slice, budget)) return std::nullopt;
  std::vector<WeighedPlace> places =
      refine_found(context, *search_, points, T_odom_base, context.config.refined, budget);
  const bool unclear = is_unclear(context.config, places);
  deep_candidates_ = deep_candidates(context.config, places, deep_candidates_);
  goes_on_ = unclear && depth_ == SearchDepth::kQuick;
  depth_ = unclear ? SearchDepth::kDeep : SearchDepth::kQuick;
  search_.reset();
  return places;
}

void PlaceSearch::cancel() {
  search_.reset();
  depth_ = SearchDepth::kQuick;
  deep_candidates_ = 0;
  goes_on_ = false;
}

std::vector<WeighedPlace> find_places(const CreateContext& context, const CascadeMatcher& matcher,
                                      const ScanPoints& points) {
  if (points.empty()) return {};
  constexpr double kUnlimited = 1e9;
  constexpr std::int64_t kWhole = std::int64_t{1} << 40;
  PlaceSearch search(matcher);
  std::vector<WeighedPlace> places;
  do {
    WorkBudget budget({kUnlimited, kUnlimited}, 1.0);
    places = *search.step(context, points, {}, kWhole, budget);
  } while (search.is_pending());
  return places;
}

}  // namespace castaway::localization
