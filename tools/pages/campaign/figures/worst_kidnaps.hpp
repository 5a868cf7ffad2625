/// The kidnaps after which a localizer was lost for longest.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "tools/pages/campaign/figures/scored_kidnap.hpp"

namespace castaway::testbed {

/// A kidnap with its cell.
struct WorstKidnap {
  int cell = 0;
  std::string name;  ///< `CampaignCell::name`
  std::uint64_t seed = 1;
  std::vector<std::pair<std::string, std::string>> values;
  std::size_t series = 0;
  ScoredKidnap kidnap;
  std::optional<double> largest_error_m;  ///< [m] Of the localizer in the cell.

  /// Longer lost, or without recovery, or with the larger error comes first.
  bool operator<(const WorstKidnap& other) const;
};

/// Keeps the worst of all kidnaps.
class WorstKidnaps {
 public:
  explicit WorstKidnaps(std::size_t most) : most_(most) {}
  void add(WorstKidnap kidnap);
  /// The worst one first.
  [[nodiscard]] const std::set<WorstKidnap>& kidnaps() const { return kidnaps_; }

 private:
  std::size_t most_;
  std::set<WorstKidnap> kidnaps_;
};

}  // namespace castaway::testbed
