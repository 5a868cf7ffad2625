/// Plots of a data set as SVG files.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace castaway::testbed {

/// Bars over equal bins from 0 on.
struct HistogramPlot {
  std::string title;
  std::string x_label;  ///< With its unit.
  double bin = 1.0;     ///< Width, in the unit of the axis.
  std::vector<double> counts;
};

/// Lines over one axis from 0 on.
struct LinesPlot {
  std::string title;
  std::string x_label;
  std::string y_label;
  struct Line {
    std::string name;
    std::vector<std::pair<double, double>> points;
  };
  std::vector<Line> lines;
};

/// A file of its own, of 640 x 320 px. Shares of all counts; bins behind the last that is not empty
/// are left out.
std::string histogram_svg(const HistogramPlot& plot);
std::string lines_svg(const LinesPlot& plot);

}  // namespace castaway::testbed
