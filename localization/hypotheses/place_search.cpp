#include "localization/hypotheses/place_search.hpp"

namespace castaway::localization {

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
      sort_out(context, search_->candidates(T_odom_base), points);
  std::vector<WeighedPlace> places = refine_candidates(context, candidates, points);
  deeper_ = search_->depth() == SearchDepth::kUsual && fits_badly(context.config, places);
  search_.reset();
  return places;
}

void PlaceSearch::cancel() {
  search_.reset();
  deeper_ = false;
}

}  // namespace castaway::localization
