/// Curves over time as inline SVG.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace castaway::testbed {

/// One localizer's curve.
struct PlotCurve {
  std::string name;
  std::size_t color = 0;  ///< Index of the style's colours.
  /// Pieces of (time [s], value); between pieces the curve is interrupted.
  std::vector<std::vector<std::pair<double, double>>> pieces;
};

/// A vertical mark.
struct PlotMark {
  double time_s = 0.0;
  std::string label;
};

/// What a plot shows.
struct TimePlot {
  std::string title;  ///< For readers who hear it.
  std::string unit{};
  double begin_s = 0.0;
  double end_s = 1.0;
  double low = 0.0;          ///< Values below are drawn here.
  double high = 1.0;         ///< Values above are drawn here.
  bool logarithmic = false;  ///< `low` and `high` then are powers of ten.
  std::vector<PlotCurve> curves{};
  std::vector<PlotMark> marks{};
  double limit = 0.0;  ///< Above 0: a thin line, the border of right and wrong.
};

/// At most `most` pairs; each stretch of time keeps its smallest and its largest value.
std::vector<std::pair<double, double>> thinned(const std::vector<std::pair<double, double>>& points,
                                               std::size_t most);

/// An `<svg>` element that fits its container.
std::string render_plot(const TimePlot& plot);

}  // namespace castaway::testbed
