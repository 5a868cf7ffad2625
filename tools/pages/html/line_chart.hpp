/// Curves with their intervals as inline SVG, for pages that need no script to show them.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "tools/pages/html/plot_data.hpp"

namespace castaway::testbed {

/// A line, and the area of its interval behind it.
struct ChartLine {
  std::string name;       ///< Plain text.
  std::size_t style = 0;  ///< Index into the palette.
  PlotPoints points;
  PlotColumn low{};  ///< Of the interval at each point; empty: none.
  PlotColumn high{};
};

/// An axis from 0 to `most`. Its label has the unit: "time [s]".
struct ChartAxis {
  std::string label;
  double most = 1.0;
};

/// A chart; `title` is read to those who do not see it.
struct LineChart {
  std::string title;
  ChartAxis x;
  ChartAxis y;
  std::vector<ChartLine> lines;
};

/// A legend and an `<svg>` below it.
std::string line_chart_html(const LineChart& chart);

/// The sample of a line of this style that stands before a name.
std::string line_sample(std::size_t style);

/// Round numbers from 0 to at most `most`, five to ten of them.
std::vector<double> axis_ticks(double most);

}  // namespace castaway::testbed
