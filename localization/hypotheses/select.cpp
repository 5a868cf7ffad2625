#include "localization/hypotheses/select.hpp"

#include <algorithm>

namespace castaway::localization {

std::optional<std::size_t> select(const std::vector<Hypothesis>& hypotheses, int current,
                                  double margin) {
  if (hypotheses.empty()) return std::nullopt;
  const auto best = std::max_element(
      hypotheses.begin(), hypotheses.end(),
      [](const Hypothesis& a, const Hypothesis& b) { return a.log_weight < b.log_weight; });
  const auto same = std::find_if(hypotheses.begin(), hypotheses.end(),
                                 [&](const Hypothesis& h) { return h.id == current; });
  const bool stay = same != hypotheses.end() && same->log_weight > best->log_weight - margin;
  return static_cast<std::size_t>((stay ? same : best) - hypotheses.begin());
}

}  // namespace castaway::localization
