#include "localization/hypotheses/merge.hpp"

namespace castaway::localization {

bool same_place(const MergeConfig& config, const SE2& a, const SE2& b) {
  return distance(a, b) < config.distance && yaw_distance(a, b) < config.yaw;
}

void merge(const MergeConfig& config, std::vector<Hypothesis>& hypotheses) {
  for (std::size_t i = 0; i < hypotheses.size(); ++i) {
    for (std::size_t j = i + 1; j < hypotheses.size();) {
      Hypothesis& first = hypotheses[i];
      Hypothesis& second = hypotheses[j];
      if (!same_place(config, first.belief.mean, second.belief.mean)) {
        ++j;
        continue;
      }
      if (second.log_weight > first.log_weight) std::swap(first, second);
      hypotheses.erase(hypotheses.begin() + static_cast<std::ptrdiff_t>(j));
    }
  }
}

void merge(const MergeConfig& config, Populations& populations) {
  const Hypothesis* output = populations.output();
  if (output == nullptr) return merge(config, populations.all);
  const SE2 T_map_output = output->belief.mean;
  merge(config, populations.all);
  if (populations.output() != nullptr) return;
  for (const Hypothesis& other : populations.all) {
    if (!same_place(config, other.belief.mean, T_map_output)) continue;
    populations.output_id = other.id;
    return;
  }
}

}  // namespace castaway::localization
