/// Figures of the cells over the varied keys, pooled over all other keys.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "tools/pages/campaign/figures/key_axis.hpp"
#include "tools/run/metrics/statistics/blocked_mean.hpp"

namespace castaway::testbed {

/// A figure at a place of an axis.
struct PooledFigure {
  BlockedMean mean;       ///< A block is a seed.
  bool is_share = false;  ///< Its values are 0 and 1: Wilson's interval, else that of the mean.

  [[nodiscard]] std::optional<Interval> interval() const;
};

/// Of each axis, place and series the mean of each figure. Memory does not grow with the cells.
/// Rows of one seed are added one after the other.
class KeyFigures {
 public:
  /// `series`: how many.
  KeyFigures(std::vector<KeyAxis> axes, std::size_t series);

  /// Adds a value of a cell to the places of all axes that the cell is at.
  void add(const CellRow& row, std::size_t series, const std::string& figure, double value);
  /// The same for a trial: its outcome is 1 or 0, and the figure a share.
  void add_trial(const CellRow& row, std::size_t series, const std::string& figure, bool success);

  [[nodiscard]] const std::vector<KeyAxis>& axes() const { return axes_; }
  /// Names of all figures, in alphabetical order.
  [[nodiscard]] std::vector<std::string> names() const;
  /// nullptr if there is no value.
  [[nodiscard]] const PooledFigure* find(std::size_t axis, std::size_t place, std::size_t series,
                                         const std::string& figure) const;
  /// The same over all cells.
  [[nodiscard]] const PooledFigure* overall(std::size_t series, const std::string& figure) const;

 private:
  using Figures = std::map<std::string, PooledFigure>;

  void add_value(const CellRow& row, std::size_t series, const std::string& figure, double value,
                 bool is_share);

  std::vector<KeyAxis> axes_;
  std::vector<Figures> overall_;                             // By series.
  std::vector<std::vector<std::vector<Figures>>> by_place_;  // By axis, place, series.
};

/// The data of the curves, for web/src/campaign_plots.js. `series`: their labels; `styles`: of the
/// palette, -1 for none.
nlohmann::ordered_json key_figures_json(const KeyFigures& figures,
                                        const std::vector<std::string>& series,
                                        const std::vector<int>& styles);

}  // namespace castaway::testbed
