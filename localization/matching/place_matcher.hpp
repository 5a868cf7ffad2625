/// Finds where on a map a scan could have been taken.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "localization/matching/staged_search.hpp"

namespace castaway::localization {

/// A pose at which a scan fits the map.
struct Candidate {
  SE2 T_map_base;  ///< Centre of the coarse cell and yaw of the step; in the atlas of a 3-D map.
  double score = 0.0;  ///< In [0, 1]: mean of the bytes under the end points.
};

/// Searches one map.
class PlaceMatcher {
 public:
  PlaceMatcher() = default;
  virtual ~PlaceMatcher() = default;
  PlaceMatcher(const PlaceMatcher&) = delete;
  PlaceMatcher& operator=(const PlaceMatcher&) = delete;
  PlaceMatcher(PlaceMatcher&&) = default;
  PlaceMatcher& operator=(PlaceMatcher&&) = default;

  /// Size of the map in coarse cells.
  [[nodiscard]] virtual std::size_t cells() const = 0;
  /// Returns candidates on free cells, best first; none for a scan without points. `most` overrides
  /// the configured number.
  [[nodiscard]] virtual std::vector<Candidate> match(const ScanPoints& points,
                                                     const std::optional<MatchWindow>& window = {},
                                                     const std::optional<int>& most = {}) const = 0;
  /// Starts a match of the whole map that runs in slices, always by branch and bound; the matcher
  /// must outlive it. Places with a score (`Candidate::score`) below `least` are left out, which
  /// prunes the search.
  [[nodiscard]] virtual StagedSearch search(const ScanPoints& points,
                                            const std::optional<int>& most = {},
                                            double least = 0.0) const = 0;
  /// Candidates that a search has found so far.
  [[nodiscard]] virtual std::vector<Candidate> candidates(const StagedSearch& search) const = 0;
};

}  // namespace castaway::localization
