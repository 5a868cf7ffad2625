/// Everything that the page of a campaign says, gathered from its rows.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "tools/batch/campaign/finished_campaign.hpp"
#include "tools/pages/campaign/figures/campaign_series.hpp"
#include "tools/pages/campaign/figures/heat_bins.hpp"
#include "tools/pages/campaign/figures/key_figures.hpp"
#include "tools/pages/campaign/figures/paired_figures.hpp"
#include "tools/pages/campaign/figures/recovery_curves.hpp"
#include "tools/pages/campaign/figures/worst_kidnaps.hpp"

namespace castaway::testbed {

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
