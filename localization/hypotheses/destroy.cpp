#include "localization/hypotheses/destroy.hpp"

#include <algorithm>
#include <functional>

namespace castaway::localization {

void destroy(const DestroyConfig& config, bool confident, std::vector<Hypothesis>& hypotheses) {
  if (hypotheses.empty()) return;
  std::vector<double> weights;
  for (const Hypothesis& hypothesis : hypotheses) weights.push_back(hypothesis.log_weight);
  std::sort(weights.begin(), weights.end(), std::greater<>());
  const auto most = static_cast<std::size_t>(confident ? config.most_confident : config.most);
  const double worst = weights[std::min(most, weights.size()) - 1];
  const double least =
      std::max(worst, weights[0] - (confident ? config.behind_confident : config.behind));
  std::erase_if(hypotheses, [&](const Hypothesis& h) { return h.log_weight < least; });
}

}  // namespace castaway::localization
