/// Where kidnaps end: their targets in square bins of the map.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "tools/pages/campaign/figures/scored_kidnap.hpp"
#include "tools/run/metrics/statistics/survival.hpp"

namespace castaway::testbed {

/// A bin, by its number along x and y: it covers [number * edge, (number + 1) * edge) of map.
using BinNumber = std::pair<int, int>;

/// Edge of the bins. [m]
inline constexpr double kBinEdge = 1.0;

/// The bin of a point in map [m], rounded to micrometres as in kidnaps.csv.
BinNumber bin_of(double x, double y);

/// Kidnaps to a bin. Those without recovery count as censored in the median of the time.
struct HeatBin {
  int kidnaps = 0;
  int failures = 0;  ///< Kidnaps without recovery.
  Survival times;

  [[nodiscard]] double failure_share() const;
  /// [s] Nothing if fewer than half recover.
  [[nodiscard]] std::optional<double> median_s() const { return times.median_s(); }
};

/// The bins of one world and localizer that have a kidnap.
using HeatBins = std::map<BinNumber, HeatBin>;

/// The bins of all worlds and localizers.
class HeatMap {
 public:
  explicit HeatMap(std::size_t series) : series_(series) {}
  /// Kidnaps without a target (an unknown start, a log without truth) are counted only.
  void add(const std::string& world, std::size_t series, const ScoredKidnap& kidnap);
  /// Worlds with a target, in alphabetical order.
  [[nodiscard]] std::vector<std::string> worlds() const;
  [[nodiscard]] const HeatBins& bins(const std::string& world, std::size_t series) const;
  [[nodiscard]] int without_target() const { return without_target_; }

 private:
  std::size_t series_ = 0;
  std::map<std::string, std::vector<HeatBins>> worlds_;
  int without_target_ = 0;
};

}  // namespace castaway::testbed
