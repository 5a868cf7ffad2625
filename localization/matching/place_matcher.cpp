#include "localization/matching/place_matcher.hpp"

#include <algorithm>
#include <utility>

namespace castaway::localization {

StagedSearch::StagedSearch(std::vector<SearchStage> stages, BestPlaces best, double perfect)
    : stages_(std::move(stages)), best_(std::move(best)), perfect_(perfect) {
  begin_stage();
}

/// The stage takes the list, and gives it back when it is complete.
void StagedSearch::begin_stage() {
  current_.reset();
  if (stage_ == stages_.size()) return;
  const SearchStage& stage = stages_[stage_];
  current_.emplace(*stage.pyramid, stage.space, stage.scans, std::move(best_));
}

bool StagedSearch::step(std::int64_t tiles) {
  const std::int64_t end = tiles_scored() + std::max<std::int64_t>(tiles, 1);
  while (current_) {
    if (!current_->step(end - tiles_scored())) return false;
    scored_ += current_->tiles_scored();
    best_ = std::move(*current_).take_best();
    ++stage_;
    begin_stage();
    if (current_ && tiles_scored() >= end) return false;
  }
  return true;
}

std::int64_t StagedSearch::tiles_scored() const {
  return scored_ + (current_ ? current_->tiles_scored() : 0);
}

}  // namespace castaway::localization
