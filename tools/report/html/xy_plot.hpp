/// Points and lines over two axes as inline SVG.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace castaway::testbed {

/// One axis.
struct PlotAxis {
  std::string label;  ///< With its unit.
  double low = 0.0;
  double high = 1.0;
  bool logarithmic = false;  ///< `low` and `high` then are powers of ten.
};

/// One set of points, or a line through them.
struct XySeries {
  std::string name;
  std::size_t color = 0;  ///< Index of the style's colours.
  bool line = false;      ///< False: dots.
  std::vector<std::pair<double, double>> points;
};

/// What a plot shows. Points beyond an axis are drawn at its end.
struct XyPlot {
  std::string title;  ///< For readers who hear it.
  PlotAxis x;
  PlotAxis y;
  std::vector<XySeries> series;
  std::string nothing = "no points";  ///< Written where no series has points.
};

/// Evenly spaced ones of the points, at most `most`.
std::vector<std::pair<double, double>> every_few(
    const std::vector<std::pair<double, double>>& points, std::size_t most);

/// An `<svg>` element that fits its container.
std::string render_xy_plot(const XyPlot& plot);

}  // namespace castaway::testbed
