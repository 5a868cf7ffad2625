#include "localization/paper/published/published_gates.hpp"

#include <cassert>

#include "localization/hypotheses/populations.hpp"

namespace castaway::localization {

int output_by_gates(const PublishedGates& gates, const std::vector<Hypothesis>& hypotheses,
                    int output_id) {
  assert(!hypotheses.empty());
  const Hypothesis* output = find_hypothesis(hypotheses, output_id);
  if (output == nullptr) output = &hypotheses.front();
  for (const Hypothesis& h : hypotheses) {
    if (h.quality > gates.good && h.quality > output->quality + gates.margin) output = &h;
  }
  return output->id;
}

bool fails_gates(const PublishedGates& gates, const Hypothesis& hypothesis, std::size_t count,
                 int most) {
  const bool full = count >= static_cast<std::size_t>(most);
  return count > 1 && hypothesis.quality < (full ? gates.low : gates.very_low);
}

}  // namespace castaway::localization
