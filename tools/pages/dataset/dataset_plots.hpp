/// Distributions of a data set: a table for its card, and plots on a page of their own.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "tools/batch/dataset/dataset_contents.hpp"

namespace castaway::testbed {

/// Counts in equal bins that start at 0; the last bin is not empty.
struct Histogram {
  std::string title;
  std::string label;  ///< Label of the axis, with its unit.
  double bin = 1.0;   ///< Bin width, in the unit of the axis.
  std::vector<double> counts{};
};

/// Histograms of ranges, occlusion and kidnaps.
std::vector<Histogram> dataset_histograms(const DatasetContents& contents);

/// Upper end of the bin that contains the quantile; `q` in (0, 1]. Nothing if there are no counts.
std::optional<double> quantile_of(const Histogram& histogram, double q);

/// Odometry errors [m] of all sequences, by the distance driven [m] since the start or the last
/// kidnap.
std::map<int, std::vector<double>> odometry_errors(const DatasetContents& contents);

/// Tables of quantiles, as Markdown.
std::string describe_distributions(const DatasetContents& contents);

/// The page of plots: histograms, and the odometry error over the distance driven. It embeds the
/// script that draws them, so it differs between builds with and without Node.js.
std::string plots_page(const DatasetContents& contents);

}  // namespace castaway::testbed
