/// Distributions of a data set: a table for its card, and plots on a page of their own.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "tools/dataset/dataset_contents.hpp"

namespace castaway::testbed {

/// Counts in equal bins from 0 on; the last bin is not empty.
struct Histogram {
  std::string title;
  std::string label;  ///< Of the axis, with its unit.
  double bin = 1.0;   ///< Width, in the unit of the axis.
  std::vector<double> counts{};
};

/// Ranges, occlusion, kidnaps.
std::vector<Histogram> dataset_histograms(const DatasetContents& contents);

/// The upper end of the bin that the quantile is in; `q` in (0, 1]. Nothing without counts.
std::optional<double> quantile_of(const Histogram& histogram, double q);

/// Errors of the odometry of all sequences [m] by the way driven [m] since the start or the last
/// kidnap.
std::map<int, std::vector<double>> odometry_errors(const DatasetContents& contents);

/// Tables of quantiles, as Markdown.
std::string describe_distributions(const DatasetContents& contents);

/// The page: histograms, and the odometry's error over the way. It holds the script that draws
/// them, so it differs between builds with and without Node.js.
std::string plots_page(const DatasetContents& contents);

}  // namespace castaway::testbed
