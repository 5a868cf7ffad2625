#include "localization/hypotheses/select.hpp"

#include <algorithm>

#include "localization/hypotheses/populations.hpp"

namespace castaway::localization {

std::optional<std::size_t> select(const std::vector<Hypothesis>& hypotheses, int current,
                                  double margin) {
  if (hypotheses.empty()) return std::nullopt;
  const auto best = std::max_element(
      hypotheses.begin(), hypotheses.end(),
      [](const Hypothesis& a, const Hypothesis& b) { return a.log_weight < b.log_weight; });
  const Hypothesis* same = find_hypothesis(hypotheses, current);
  const bool stay = same != nullptr && same->log_weight > best->log_weight - margin;
  return static_cast<std::size_t>((stay ? same : &*best) - hypotheses.data());
}

}  // namespace castaway::localization
