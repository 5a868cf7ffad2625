// What MH-AMCL tells: the estimate with its alternatives, and its diagnostics.
#include <algorithm>

#include "localization/mh_amcl.hpp"

namespace castaway::localization {

void MhAmcl::publish(Stamp stamp) {
  const Hypothesis* output = selected();
  if (output == nullptr) {
    estimate_.reset();
    return;
  }
  const std::optional<SE2> T_odom_then = intake_.T_odom_base().at(stamp);
  const SE2 T_now_then = predicted_at_->inverse() * T_odom_then.value_or(*predicted_at_);
  Estimate estimate;
  estimate.stamp = stamp;
  estimate.T_map_base = output->belief.mean * T_now_then;
  estimate.covariance = output->belief.covariance;
  estimate.quality = output->quality;
  estimate.probability = probability_;
  estimate.lost = paper_ ? probability_ < config_.paper.rules.right_from : !found_;
  const std::vector<double> all = shares(hypotheses_, unlisted_);
  for (std::size_t i = 0; i < hypotheses_.size(); ++i) {
    if (hypotheses_[i].id == selected_id_) continue;
    estimate.alternatives.push_back({hypotheses_[i].belief.mean * T_now_then, all[i]});
  }
  std::stable_sort(estimate.alternatives.begin(), estimate.alternatives.end(),
                   [](const Alternative& a, const Alternative& b) { return a.share > b.share; });
  estimate_ = std::move(estimate);
}

Diagnostics MhAmcl::diagnostics() const {
  Diagnostics diagnostics;
  const std::vector<double> all = shares(hypotheses_, unlisted_);
  for (std::size_t i = 0; i < hypotheses_.size(); ++i) {
    const Hypothesis& h = hypotheses_[i];
    diagnostics.populations.push_back(
        {h.id, h.belief.mean, h.quality, all[i], h.id == selected_id_, h.particles.poses});
  }
  diagnostics.dropped_scans = intake_.dropped_scans();
  diagnostics.dropped_odometry = intake_.dropped_odometry();
  diagnostics.cpu_by_stage = timer_.totals();
  return diagnostics;
}

}  // namespace castaway::localization
