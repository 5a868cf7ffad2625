/// Everything that the page of a campaign says, gathered from its rows.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "tools/batch/campaign/finished_campaign.hpp"
#include "tools/pages/campaign/figures/campaign_series.hpp"
#include "tools/pages/campaign/figures/key_figures.hpp"
#include "tools/pages/campaign/figures/paired_figures.hpp"
#include "tools/pages/campaign/figures/recovery_curves.hpp"
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

/// Cells with one reason for being void or failed.
struct UnscoredCells {
  CellOutcome state = CellOutcome::kFailed;
  int cells = 0;
  int first = 0;  ///< The first of them.
};

/// All figures are of cells that are done. Memory grows with the grid and the map, not with the
/// seeds.
struct CampaignFigures {
  CampaignFigures(std::vector<CampaignSeries> of_localizers, const std::vector<KeyAxis>& axes);

  std::vector<CampaignSeries> series;
  std::map<CellOutcome, int> states;
  std::map<std::string, UnscoredCells> reasons;  ///< At most 100.
  KeyFigures figures;  ///< Metrics; series number `series.size()` has those of the run.
  RecoveryCurves recoveries;
  LocalizerPairs pairs;
  HeatMap heat;
  std::map<std::string, int> worlds;  ///< A cell of each world.
  WorstKidnaps worst;

  /// Labels of all series, that of the run included.
  [[nodiscard]] std::vector<std::string> labels() const;
  [[nodiscard]] int cells(CellOutcome state) const;
};

/// Name of the share of recovered kidnaps among the figures.
inline constexpr const char* kRecovered = "recovery.success";
/// Name of the mean tracking error among the figures and the metrics.
inline constexpr const char* kTracking = "tracking_error_m.mean";

/// Reads every row twice, one at a time.
CampaignFigures gather_figures(const FinishedCampaign& campaign);

}  // namespace castaway::testbed
