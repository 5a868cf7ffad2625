/// Times to recovery of the localizers, overall and over the varied keys.
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "tools/pages/campaign/figures/key_axis.hpp"
#include "tools/pages/campaign/figures/scored_kidnap.hpp"
#include "tools/run/metrics/statistics/survival.hpp"

namespace castaway::testbed {

/// Survival of each localizer, overall and at each place of each axis.
class RecoveryCurves {
 public:
  /// `series`: how many.
  RecoveryCurves(const std::vector<KeyAxis>& axes, std::size_t series);
  void add(const CellRow& row, std::size_t series, const ScoredKidnap& kidnap);

  [[nodiscard]] const std::vector<KeyAxis>& axes() const { return axes_; }
  [[nodiscard]] const Survival& overall(std::size_t series) const { return overall_[series]; }
  [[nodiscard]] const Survival& at(std::size_t axis, std::size_t place, std::size_t series) const {
    return by_place_[axis][place][series];
  }

 private:
  std::vector<KeyAxis> axes_;
  std::vector<Survival> overall_;
  std::vector<std::vector<std::vector<Survival>>> by_place_;  // By axis, place, series.
};

/// The data of the curves: groups of plots, the first one of all kidnaps, then one for each key.
/// web/src/campaign_choices.js draws it. `series`: their labels; `styles`: of the palette.
nlohmann::ordered_json recovery_curves_json(const RecoveryCurves& curves,
                                            const std::vector<std::string>& series,
                                            const std::vector<int>& styles);

}  // namespace castaway::testbed
