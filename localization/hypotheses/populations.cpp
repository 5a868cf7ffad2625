#include "localization/hypotheses/populations.hpp"

#include <algorithm>

namespace castaway::localization {

const Hypothesis* find_hypothesis(const std::vector<Hypothesis>& hypotheses, int id) {
  const auto found = std::find_if(hypotheses.begin(), hypotheses.end(),
                                  [&](const Hypothesis& h) { return h.id == id; });
  return found == hypotheses.end() ? nullptr : &*found;
}

}  // namespace castaway::localization
