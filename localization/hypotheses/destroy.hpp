/// Destroy: populations that the scans speak against are removed, never the last one (paper,
/// section IV).
#pragma once

#include <vector>

#include "localization/hypotheses/hypothesis.hpp"

namespace castaway::localization {

/// Which hypotheses go.
struct DestroyConfig {
  double behind = 14.0;    ///< [nats] So far behind the best one.
  int most_confident = 8;  ///< So many are kept while one is confident...
  int most = 30;           ///< ...and so many while the place is ambiguous.
};

/// Removes what is too far behind, then the lightest until at most `most` are left. The best one
/// stays in any case; the order of those that stay is kept.
void destroy(const DestroyConfig& config, bool confident, std::vector<Hypothesis>& hypotheses);

}  // namespace castaway::localization
