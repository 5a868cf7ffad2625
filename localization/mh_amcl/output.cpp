#include "localization/mh_amcl/output.hpp"

#include <algorithm>

namespace castaway::localization {

std::optional<Estimate> estimate_of(const Populations& populations,
                                    const std::vector<double>& shares, bool lost, Stamp stamp,
                                    const SE2& T_now_base) {
  const Hypothesis* output = populations.output();
  if (output == nullptr) return std::nullopt;
  Estimate estimate;
  estimate.stamp = stamp;
  estimate.T_map_base = output->belief.mean * T_now_base;
  estimate.covariance = output->belief.covariance;
  estimate.quality = output->quality;
  estimate.probability = populations.probability;
  estimate.lost = lost;
  for (std::size_t i = 0; i < populations.all.size(); ++i) {
    const Hypothesis& other = populations.all[i];
    if (other.id == output->id) continue;
    estimate.alternatives.push_back({other.belief.mean * T_now_base, shares[i]});
  }
  std::stable_sort(estimate.alternatives.begin(), estimate.alternatives.end(),
                   [](const Alternative& a, const Alternative& b) { return a.share > b.share; });
  return estimate;
}

Diagnostics diagnostics_of(const Populations& populations, const std::vector<double>& shares,
                           const Intake& intake, const StageTimer& timer) {
  Diagnostics diagnostics;
  for (std::size_t i = 0; i < populations.all.size(); ++i) {
    const Hypothesis& h = populations.all[i];
    diagnostics.populations.push_back(
        {h.id, h.belief.mean, h.quality, shares[i], h.id == populations.output_id,
         h.mixture.empty() ? h.particles.poses : sigma_points(h.mixture)});
  }
  diagnostics.dropped_scans = intake.dropped_scans();
  diagnostics.dropped_odometry = intake.dropped_odometry();
  diagnostics.cpu_by_stage = timer.totals();
  return diagnostics;
}

}  // namespace castaway::localization
