/// Plots of a log's data beside the models that were fitted to it.
#pragma once

#include <vector>

#include <nlohmann/json.hpp>

#include "tools/report/html/plot_data.hpp"
#include "tools/twin/log_fit.hpp"

namespace castaway::testbed {

/// The cumulative distribution of ascending samples.
PlotPoints cumulative(const std::vector<double>& samples);

/// A list of plots for `plots_html`: odometry, noise, losses, mixed pixels, clock and periods, as
/// far as the log tells them.
nlohmann::ordered_json model_plots(const FittedLog& fitted);

}  // namespace castaway::testbed
