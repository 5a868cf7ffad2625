/// Destroy: removes populations that are unlikely given the scans, except the last one (paper,
/// section IV).
#pragma once

#include <vector>

#include "localization/hypotheses/hypothesis.hpp"

namespace castaway::localization {

/// Limits of the set of hypotheses.
struct DestroyConfig {
  double behind = 14.0;  ///< [nats] Hypotheses further behind the best one are removed.
  /// [nats] The same while the output is confident: look-alikes are kept, so that they can take
  /// over as soon as the scans favour them.
  double behind_confident = 22.0;
  int most_confident = 4;  ///< Maximum number while the output is confident.
  int most = 30;           ///< Maximum number while the place is ambiguous.
};

/// Removes hypotheses that are too far behind the best one, then the lightest ones above the
/// maximum number. The best one always stays, and the order of the others is kept.
void destroy(const DestroyConfig& config, bool confident, std::vector<Hypothesis>& hypotheses);

}  // namespace castaway::localization
