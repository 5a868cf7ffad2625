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

}  // namespace castaway::localization
