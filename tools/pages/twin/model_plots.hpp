/// Plots of a log's data beside the models that were fitted to it.
#pragma once

#include <nlohmann/json.hpp>

#include "tools/twin/log_fit.hpp"

namespace castaway::testbed {

/// A list of plots for `plots_html`: odometry, slips, the lidar, clock and periods, as far as the
/// log tells them.
nlohmann::ordered_json model_plots(const FittedLog& fitted);

}  // namespace castaway::testbed
