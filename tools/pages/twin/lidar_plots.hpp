/// Plots of what a log tells of its lidar beside the models that were fitted to it.
#pragma once

#include <nlohmann/json.hpp>

#include "tools/twin/log_fit.hpp"

namespace castaway::testbed {

/// A list of plots for `plots_html`: noise, losses, mixed pixels, dust, offsets of beams and the
/// maximum range, as far as the log tells them.
nlohmann::ordered_json lidar_plots(const FittedLog& fitted);

}  // namespace castaway::testbed
