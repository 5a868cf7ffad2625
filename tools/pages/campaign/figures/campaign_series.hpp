/// The localizers of a campaign, as the page tells them apart.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "tools/batch/campaign/cell_row.hpp"
#include "tools/pages/campaign/figures/value_labels.hpp"

namespace castaway::testbed {

/// Key of a grid whose values are lists of localizers.
inline constexpr const char* kLocalizersKey = "localizers";

/// Of a varied key in a row; nothing if it does not vary.
const std::string* value_of(const CellRow& row, const std::string& key);

/// True if the row has a metric or a kidnap of a localizer.
bool has_localizer(const CellRow& row, const std::string& localizer);

/// A localizer. Localizers of one name with several settings are several series.
struct CampaignSeries {
  std::string localizer;
  std::string setting;  ///< The value of `localizers` that it stands for; empty: all of them.
  std::string label{};  ///< In few words: "amcl (preset amcl-recovery)".

  [[nodiscard]] bool in(const CellRow& row) const;
};

/// Index into the palette of each series, and -1 for the figures of the run, which are the last.
std::vector<int> series_styles(const std::vector<CampaignSeries>& series);

/// Collects the series of a campaign from its rows.
class SeriesFinder {
 public:
  /// `localizers`: of all cells.
  explicit SeriesFinder(std::vector<std::string> localizers, ValueLabels labels = {})
      : localizers_(std::move(localizers)),
        labels_(std::move(labels)),
        settings_(localizers_.size()) {}
  void add(const CellRow& row);
  /// In the order of the localizers, then of the cells.
  [[nodiscard]] std::vector<CampaignSeries> series() const;

 private:
  std::vector<std::string> localizers_;
  ValueLabels labels_;
  std::vector<std::vector<std::string>> settings_;  // Values of `localizers` with each localizer.
};

}  // namespace castaway::testbed
