#include "localization/search/map_search.hpp"

#include <algorithm>

namespace castaway::localization {
namespace {

constexpr std::int64_t kTilesPerCandidate = 60;  // Estimates: to screen, and to refine.
constexpr std::int64_t kTilesPerPlace = 800;

ScanPoints points_of(const CreateConfig& config, const ScanPoints& points, SearchDepth depth) {
  const bool by_far = config.far_share > 0.0 && depth == SearchDepth::kDeep;
  return by_far ? farthest_points(points, config.far_share) : points;
}

double separation(const SE2& a, const SE2& b) { return distance(a, b) + yaw_distance(a, b); }

/// True if the last of the candidates scores about as well as the one next to a pose.
bool last_is_as_good(const std::vector<Candidate>& candidates, const SE2& T_map_base) {
  constexpr double kAsGood = 0.95;  // Share of the score.
  const auto next = std::min_element(candidates.begin(), candidates.end(), [&](auto& a, auto& b) {
    return separation(a.T_map_base, T_map_base) < separation(b.T_map_base, T_map_base);
  });
  return candidates.back().score >= kAsGood * next->score;
}

}  // namespace

MapSearch::MapSearch(const CreateConfig& config, const PlaceMatcher& matcher,
                     const ScanPoints& points, const SE2& T_odom_base, SearchDepth depth)
    : MapSearch(matcher, points_of(config, points, depth), T_odom_base,
                depth == SearchDepth::kDeep ? config.deep_candidates : config.quick_candidates,
                0.0) {}

MapSearch::MapSearch(const PlaceMatcher& matcher, const ScanPoints& points, const SE2& T_odom_base,
                     int most, double least)
    : matcher_(&matcher), most_(most), T_odom_base_(T_odom_base) {
  if (!points.empty()) search_ = matcher.search(points, most, least);
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
  std::vector<Candidate> all = matcher_->candidates(*search_);
  if (u == SE2{}) return all;
  for (Candidate& candidate : all) candidate.T_map_base = candidate.T_map_base * u;
  return all;
}

std::int64_t MapSearch::tiles_to_refine(int most) const {
  return kTilesPerCandidate * most_ + kTilesPerPlace * std::min(most_, most);
}

FoundPlaces refine_found(const CreateContext& context, const MapSearch& search,
                         const ScanPoints& points, const SE2& T_odom_base, int most,
                         WorkBudget& budget) {
  const std::vector<Candidate> listed = search.candidates(T_odom_base);
  const std::vector<Candidate> screened = screen_candidates(context, listed, points, most);
  budget.spend(kTilesPerCandidate * static_cast<std::int64_t>(listed.size()) +
               kTilesPerPlace * static_cast<std::int64_t>(screened.size()));
  FoundPlaces found{refine_candidates(context, screened, points)};
  found.more = !found.places.empty() && listed.size() == static_cast<std::size_t>(search.most()) &&
               last_is_as_good(listed, found.places.front().T_map_base);
  return found;
}

std::optional<FoundPlaces> PlaceSearch::step(const CreateContext& context, const ScanPoints& points,
                                             const SE2& T_odom_base, std::int64_t slice,
                                             WorkBudget& budget) {
  if (!search_) {
    CreateConfig config = context.config;
    if (depth_ == SearchDepth::kDeep) config.deep_candidates = deep_candidates_;
    search_.emplace(config, matcher_, points, T_odom_base, depth_);
  }
  if (!search_->step(slice, budget)) return std::nullopt;
  if (!budget.affords(search_->tiles_to_refine(context.config.refined))) return std::nullopt;
  FoundPlaces found =
      refine_found(context, *search_, points, T_odom_base, context.config.refined, budget);
  const bool unclear = is_unclear(context.config, found.places);
  deep_candidates_ = deep_candidates(context.config, found.places, deep_candidates_);
  goes_on_ = unclear && depth_ == SearchDepth::kQuick;
  depth_ = unclear ? SearchDepth::kDeep : SearchDepth::kQuick;
  search_.reset();
  return found;
}

void PlaceSearch::cancel() {
  search_.reset();
  depth_ = SearchDepth::kQuick;
  deep_candidates_ = 0;
  goes_on_ = false;
}

std::vector<WeighedPlace> find_places(const CreateContext& context, const PlaceMatcher& matcher,
                                      const ScanPoints& points) {
  if (points.empty()) return {};
  constexpr double kUnlimited = 1e9;
  constexpr std::int64_t kWhole = std::int64_t{1} << 40;
  PlaceSearch search(matcher);
  std::vector<WeighedPlace> places;
  do {
    WorkBudget budget({kUnlimited, kUnlimited}, 1.0);
    places = search.step(context, points, {}, kWhole, budget)->places;
  } while (search.is_pending());
  return places;
}

}  // namespace castaway::localization
