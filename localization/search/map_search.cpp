#include "localization/search/map_search.hpp"

#include <array>
#include <set>

namespace castaway::localization {

MapSearch::MapSearch(const CreateConfig& config, const CascadeMatcher& matcher,
                     const ScanPoints& points, const SE2& T_odom_base, SearchDepth depth)
    : matcher_(&matcher), T_odom_base_(T_odom_base), depth_(depth) {
  const bool by_far = config.far_share > 0.0;
  const ScanPoints far = by_far ? farthest_points(points, config.far_share) : ScanPoints{};
  if (depth == SearchDepth::kDeep) {
    add(by_far ? far : points, config.deep_candidates);
  } else {
    add(points, matcher.config().candidates);
    if (by_far) add(far, matcher.config().candidates);
  }
}

void MapSearch::add(const ScanPoints& points, int most) {
  if (!points.empty()) parts_.push_back({matcher_->search(points, {}, most), points.size()});
}

bool MapSearch::step(std::int64_t tiles) {
  for (Part& part : parts_) {
    if (part.search.complete()) continue;
    const std::int64_t before = part.search.tiles_scored();
    if (!part.search.step(tiles)) return false;
    tiles -= part.search.tiles_scored() - before;
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

std::optional<std::vector<WeighedPlace>> PlaceSearch::step(const CreateContext& context,
                                                           const ScanPoints& points,
                                                           const SE2& T_odom_base) {
  if (!search_) {
    const SearchDepth depth = deeper_ ? SearchDepth::kDeep : SearchDepth::kUsual;
    search_.emplace(context.config, matcher_, points, T_odom_base, depth);
    deeper_ = false;
  }
  if (!search_->step(slice_)) return std::nullopt;
  const std::vector<Candidate> candidates =
      screen_candidates(context, search_->candidates(T_odom_base), points);
  std::vector<WeighedPlace> places = refine_candidates(context, candidates, points);
  deeper_ = search_->depth() == SearchDepth::kUsual && fits_badly(context.config, places);
  search_.reset();
  return places;
}

void PlaceSearch::cancel() {
  search_.reset();
  deeper_ = false;
}

std::vector<WeighedPlace> find_places(const CreateContext& context, const CascadeMatcher& matcher,
                                      const ScanPoints& points) {
  const auto search_map = [&](SearchDepth depth) {
    constexpr std::int64_t kSlice = 1 << 20;  // Has no effect on the result.
    MapSearch search(context.config, matcher, points, {}, depth);
    while (!search.step(kSlice)) {
    }
    return refine_candidates(context, screen_candidates(context, search.candidates({}), points),
                             points);
  };
  std::vector<WeighedPlace> places = search_map(SearchDepth::kUsual);
  if (points.empty() || !fits_badly(context.config, places)) return places;
  return search_map(SearchDepth::kDeep);
}

}  // namespace castaway::localization
