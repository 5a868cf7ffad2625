// Mode `paper` of MH-AMCL: populations come from the cascade and are selected by their quality.
#include <algorithm>
#include <string>

#include "localization/mh_amcl.hpp"

namespace castaway::localization {

/// The best population, unless the present one is hardly worse or was worse only for a moment.
void MhAmcl::choose_by_quality() {
  const QualityRules& rules = config_.paper.rules;
  const auto best = best_by_quality(hypotheses_);
  if (!best) return;
  const Hypothesis* present = selected();
  const Hypothesis& other = hypotheses_[*best];
  const bool better = present == nullptr || other.quality > present->quality + rules.select_margin;
  if (!better) better_since_.reset();
  if (better && !better_since_) better_since_ = last_correct_;
  const bool long_enough =
      better && (present == nullptr || seconds(*last_correct_ - *better_since_) >= rules.select_s);
  if (long_enough) {
    selected_id_ = other.id;
    better_since_.reset();
  }
  probability_ = selected()->quality;
}

/// New populations where the cascade finds the scan, far from those there are.
bool MhAmcl::spawn_by_quality(const ScanPoints& points) {
  const QualityRules& rules = config_.paper.rules;
  const double s = config_.paper.spawn_sigma;
  const double r = config_.paper.spawn_sigma_yaw;
  const std::size_t before = hypotheses_.size();
  for (const Candidate& candidate : paper_->cascade.match(points)) {
    if (hypotheses_.size() >= static_cast<std::size_t>(rules.most)) break;
    if (candidate.score < rules.candidate_from) break;
    if (!is_apart(rules, hypotheses_, candidate.T_map_base)) continue;
    spawn({candidate.T_map_base, Eigen::Vector3d(s * s, s * s, r * r).asDiagonal()}, 0.0, {});
    correct_by_rays(hypotheses_.back(), paper_->model, points);
  }
  return hypotheses_.size() > before;
}

}  // namespace castaway::localization
