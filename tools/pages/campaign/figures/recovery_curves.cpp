#include "tools/pages/campaign/figures/recovery_curves.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "tools/pages/html/plot_data.hpp"

namespace castaway::testbed {
namespace {

using RecoveryJson = nlohmann::ordered_json;

/// Corners of the stairs of a curve and its 95 % interval.
struct Stairs {
  PlotPoints curve;
  PlotColumn low;
  PlotColumn high;

  void add(double time_s, double survival, const Interval& interval) {
    curve.emplace_back(time_s, survival);
    low.emplace_back(interval.low);
    high.emplace_back(interval.high);
  }
};

/// Thinned to about 120 steps.
Stairs stairs(const Survival& survival) {
  constexpr std::size_t kMostSteps = 120;
  if (survival.size() == 0) return {};
  const std::vector<SurvivalStep> steps = survival.steps();
  const std::size_t stride = steps.size() / kMostSteps + 1;
  SurvivalStep last{0.0, survival.size(), 0, 1.0, {1.0, 1.0}};
  Stairs corners;
  corners.add(last.time_s, last.survival, last.interval);
  for (std::size_t i = 0; i < steps.size(); i += stride) {
    const SurvivalStep& step = steps[std::min(i + stride, steps.size()) - 1];
    corners.add(step.time_s, last.survival, last.interval);
    corners.add(step.time_s, step.survival, step.interval);
    last = step;
  }
  corners.add(std::max(survival.longest_s(), last.time_s), last.survival, last.interval);
  return corners;
}

RecoveryJson recovery_line(const std::string& label, int style, const Survival& times) {
  const Stairs corners = stairs(times);
  RecoveryJson line =
      point_series(fmt::format("{} (n = {})", label, times.size()), "band", corners.curve);
  line["low"] = plot_numbers(corners.low);
  line["high"] = plot_numbers(corners.high);
  line["color"] = style;
  return line;
}

/// Labels of the series with their styles.
struct SeriesTexts {
  const std::vector<std::string>& labels;
  const std::vector<int>& styles;
};

/// A plot of all localizers; `survival(k)`: of series k.
template <typename SurvivalOf>
RecoveryJson recovery_plot(const std::string& title, const SeriesTexts& series, double longest_s,
                           SurvivalOf survival) {
  RecoveryJson lines = RecoveryJson::array();
  for (std::size_t k = 0; k < series.labels.size(); ++k) {
    lines.push_back(recovery_line(series.labels[k], series.styles[k], survival(k)));
  }
  return {{"title", title},
          {"x", {{"label", "time since the kidnap [s]"}, {"range", {0.0, longest_s}}}},
          {"y", {{"label", "share not yet recovered"}, {"range", {0, 1}}}},
          {"series", std::move(lines)},
          {"nothing", "No kidnaps."}};
}

double longest_of(const RecoveryCurves& curves, std::size_t series) {
  double longest = 1.0;  // [s]
  for (std::size_t k = 0; k < series; ++k) {
    longest = std::max(longest, curves.overall(k).longest_s());
  }
  return longest;
}

}  // namespace

RecoveryCurves::RecoveryCurves(const std::vector<KeyAxis>& axes, std::size_t series)
    : axes_(axes), overall_(series) {
  for (const KeyAxis& axis : axes_) {
    by_place_.emplace_back(axis.places().size(), std::vector<Survival>(series));
  }
}

void RecoveryCurves::add(const CellRow& row, std::size_t series, const ScoredKidnap& kidnap) {
  overall_[series].add(kidnap.lost_s, kidnap.kidnap.recovered);
  for (std::size_t axis = 0; axis < axes_.size(); ++axis) {
    const auto place = axes_[axis].place_of(row);
    if (place) by_place_[axis][*place][series].add(kidnap.lost_s, kidnap.kidnap.recovered);
  }
}

RecoveryJson recovery_curves_json(const RecoveryCurves& curves,
                                  const std::vector<std::string>& series,
                                  const std::vector<int>& styles) {
  const SeriesTexts texts{series, styles};
  const double longest = longest_of(curves, series.size());
  const auto overall = [&](std::size_t k) -> const Survival& { return curves.overall(k); };
  RecoveryJson groups = RecoveryJson::array();
  groups.push_back(
      {{"name", "all kidnaps"},
       {"plots", RecoveryJson::array({recovery_plot("All kidnaps", texts, longest, overall)})}});
  for (std::size_t axis = 0; axis < curves.axes().size(); ++axis) {
    const KeyAxis& key = curves.axes()[axis];
    RecoveryJson plots = RecoveryJson::array();
    for (std::size_t place = 0; place < key.places().size(); ++place) {
      const auto here = [&](std::size_t k) -> const Survival& { return curves.at(axis, place, k); };
      plots.push_back(recovery_plot(fmt::format("{} = {}", key.key(), key.places()[place].label),
                                    texts, longest, here));
    }
    groups.push_back({{"name", key.key()}, {"plots", std::move(plots)}});
  }
  return groups;
}

}  // namespace castaway::testbed
