#include "localization/search/map_search.hpp"

#include <array>
#include <set>

namespace castaway::localization {
namespace {

SearchDepth deeper(SearchDepth depth) {
  return depth == SearchDepth::kQuick ? SearchDepth::kUsual : SearchDepth::kDeep;
}

}  // namespace

MapSearch::MapSearch(const CreateConfig& config, const CascadeMatcher& matcher,
                     const ScanPoints& points, const SE2& T_odom_base, SearchDepth depth)
    : matcher_(&matcher), T_odom_base_(T_odom_base) {
  const bool by_far = config.far_share > 0.0 && depth != SearchDepth::kQuick;
  const ScanPoints far = by_far ? farthest_points(points, config.far_share) : ScanPoints{};
  if (depth == SearchDepth::kDeep) {
    add(by_far ? far : points, config.deep_candidates);
    return;
  }
  add(points, depth == SearchDepth::kQuick ? config.quick_candidates : matcher.config().candidates);
  if (by_far) add(far, matcher.config().candidates);
}

MapSearch::MapSearch(const CascadeMatcher& matcher, const ScanPoints& points,
                     const SE2& T_odom_base, int most, double least)
    : matcher_(&matcher), T_odom_base_(T_odom_base) {
  add(points, most, least);
}

void MapSearch::add(const ScanPoints& points, int most, double least) {
  if (!points.empty()) parts_.push_back({matcher_->search(points, {}, most, least), points.size()});
}

bool MapSearch::step(std::int64_t tiles, WorkBudget& budget) {
  std::int64_t left = budget.grant(tiles);
  for (Part& part : parts_) {
    if (part.search.complete()) continue;
    const std::int64_t before = part.search.tiles_scored();
    const bool complete = part.search.step(left);
    const std::int64_t done = part.search.tiles_scored() - before;
    budget.spend(done);
    if (!complete) return false;
    left -= done;
  }
  return true;
}

/// A place found by both parts is returned once.
std::vector<Candidate> MapSearch::candidates(const SE2& T_odom_base) const {
  const SE2 u = T_odom_base_.inverse() * T_odom_base;
  std::set<std::array<double, 3>> known;
  std::vector<Candidate> all;
  for (const Part& part : parts_) {
    for (Candidate candidate : matcher_->candidates(part.search.best(), part.points)) {
      const SE2 pose = candidate.T_map_base;
      if (!known.insert({pose.x, pose.y, pose.yaw}).second) continue;
      if (!(u == SE2{})) candidate.T_map_base = pose * u;
      all.push_back(candidate);
    }
  }
  return all;
}

std::vector<WeighedPlace> refine_found(const CreateContext& context, const MapSearch& search,
                                       const ScanPoints& points, const SE2& T_odom_base, int most,
                                       WorkBudget& budget) {
  constexpr std::int64_t kTilesPerCandidate = 20;  // Estimates: to screen, and to refine.
  constexpr std::int64_t kTilesPerPlace = 800;
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
  if (!search_) search_.emplace(context.config, matcher_, points, T_odom_base, depth_);
  if (!search_->step(slice, budget)) return std::nullopt;
  std::vector<WeighedPlace> places =
      refine_found(context, *search_, points, T_odom_base, context.config.refined, budget);
  const bool deepest = depth_ == SearchDepth::kDeep;
  depth_ = !deepest && is_unclear(context.config, places) ? deeper(depth_) : SearchDepth::kQuick;
  search_.reset();
  return places;
}

void PlaceSearch::cancel() {
  search_.reset();
  depth_ = SearchDepth::kQuick;
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
