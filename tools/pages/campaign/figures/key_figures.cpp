#include "tools/pages/campaign/figures/key_figures.hpp"

#include <array>
#include <cmath>
#include <set>

#include <nlohmann/json.hpp>

#include "tools/pages/campaign/figures/units.hpp"
#include "tools/pages/html/plot_data.hpp"
#include "tools/run/metrics/statistics/intervals.hpp"

namespace castaway::testbed {
namespace {

using FigureJson = nlohmann::ordered_json;

/// A series of a plot over the places of an axis; null if it has no point.
FigureJson series_json(const KeyFigures& figures, std::size_t axis, std::size_t series,
                       const std::string& name) {
  std::array<PlotColumn, 5> columns;  // Place, mean, ends of the interval, count.
  const std::size_t places = figures.axes()[axis].places().size();
  for (std::size_t place = 0; place < places; ++place) {
    const PooledFigure* figure = figures.find(axis, place, series, name);
    if (figure == nullptr) continue;
    const double mean = figure->mean.mean();
    const Interval ends = figure->interval().value_or(Interval{mean, mean});
    columns[0].emplace_back(static_cast<double>(place));
    columns[1].emplace_back(mean);
    columns[2].emplace_back(ends.low);
    columns[3].emplace_back(ends.high);
    columns[4].emplace_back(static_cast<double>(figure->mean.count()));
  }
  if (columns[0].empty()) return nullptr;
  return {{"series", series},
          {"at", plot_numbers(columns[0], 9)},
          {"y", plot_numbers(columns[1], 4)},
          {"low", plot_numbers(columns[2], 4)},
          {"high", plot_numbers(columns[3], 4)},
          {"n", plot_numbers(columns[4], 9)}};
}

FigureJson axis_json(const KeyFigures& figures, std::size_t axis, std::size_t series,
                     const std::vector<std::string>& names) {
  const KeyAxis& key = figures.axes()[axis];
  FigureJson json{{"key", key.key()}, {"unit", key_unit(key.key())}, {"numeric", key.is_numeric()}};
  PlotColumn x;
  json["labels"] = FigureJson::array();
  for (const AxisPlace& place : key.places()) {
    json["labels"].push_back(place.label);
    x.emplace_back(place.x);
  }
  json["x"] = plot_numbers(x, 6);
  json["figures"] = FigureJson::array();
  for (const std::string& name : names) {
    FigureJson all = FigureJson::array();
    for (std::size_t k = 0; k < series; ++k) {
      FigureJson one = series_json(figures, axis, k, name);
      if (!one.is_null()) all.push_back(std::move(one));
    }
    json["figures"].push_back(std::move(all));
  }
  return json;
}

}  // namespace

std::optional<Interval> PooledFigure::interval() const {
  if (!is_share) return mean.interval();
  const auto trials = static_cast<int>(mean.count());
  const auto successes = static_cast<int>(std::lround(mean.mean() * trials));
  const RateInterval wilson = wilson_interval(successes, trials);
  return Interval{successes == 0 ? 0.0 : wilson.low, wilson.high};  // Without its rounding.
}

KeyFigures::KeyFigures(std::vector<KeyAxis> axes, std::size_t series)
    : axes_(std::move(axes)), overall_(series) {
  for (const KeyAxis& axis : axes_) {
    by_place_.emplace_back(axis.places().size(), std::vector<Figures>(series));
  }
}

void KeyFigures::add_value(const CellRow& row, std::size_t series, const std::string& figure,
                           double value, bool is_share) {
  const auto add_to = [&](Figures& figures) {
    PooledFigure& pooled = figures[figure];
    pooled.is_share = is_share;
    pooled.mean.add(value, row.seed);
  };
  add_to(overall_[series]);
  for (std::size_t axis = 0; axis < axes_.size(); ++axis) {
    const auto place = axes_[axis].place_of(row);
    if (place) add_to(by_place_[axis][*place][series]);
  }
}

void KeyFigures::add(const CellRow& row, std::size_t series, const std::string& figure,
                     double value) {
  add_value(row, series, figure, value, false);
}

void KeyFigures::add_trial(const CellRow& row, std::size_t series, const std::string& figure,
                           bool success) {
  add_value(row, series, figure, success ? 1.0 : 0.0, true);
}

std::vector<std::string> KeyFigures::names() const {
  std::set<std::string> names;
  for (const Figures& figures : overall_) {
    for (const auto& [name, figure] : figures) names.insert(name);
  }
  return {names.begin(), names.end()};
}

const PooledFigure* KeyFigures::find(std::size_t axis, std::size_t place, std::size_t series,
                                     const std::string& figure) const {
  const Figures& figures = by_place_[axis][place][series];
  const auto found = figures.find(figure);
  return found == figures.end() ? nullptr : &found->second;
}

const PooledFigure* KeyFigures::overall(std::size_t series, const std::string& figure) const {
  const auto found = overall_[series].find(figure);
  return found == overall_[series].end() ? nullptr : &found->second;
}

FigureJson key_figures_json(const KeyFigures& figures, const std::vector<std::string>& series,
                            const std::vector<int>& styles) {
  const std::vector<std::string> names = figures.names();
  FigureJson axes = FigureJson::array();
  for (std::size_t axis = 0; axis < figures.axes().size(); ++axis) {
    axes.push_back(axis_json(figures, axis, series.size(), names));
  }
  FigureJson units = FigureJson::array();
  for (const std::string& name : names) units.push_back(metric_unit(name));
  return {{"series", series},
          {"styles", styles},
          {"names", names},
          {"units", std::move(units)},
          {"axes", std::move(axes)}};
}

}  // namespace castaway::testbed
