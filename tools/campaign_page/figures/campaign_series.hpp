/// The localizers of a campaign, as the page tells them apart.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "tools/cells/rows/cell_row.hpp"

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

  [[nodiscard]] std::string label() const;
  [[nodiscard]] bool in(const CellRow& row) const;
};

/// Collects the series of a campaign from its rows.
class SeriesFinder {
 public:
  /// `localizers`: of all cells.
  explicit SeriesFinder(std::vector<std::string> localizers)
      : localizers_(std::move(localizers)), settings_(localizers_.size()) {}
  void add(const CellRow& row);
  /// In the order of the localizers, then of the cells.
  [[nodiscard]] std::vector<CampaignSeries> series() const;

 private:
  std::vector<std::string> localizers_;
  std::vector<std::vector<std::string>> settings_;  // Values of `localizers` with each localizer.
};

}  // namespace castaway::testbed
