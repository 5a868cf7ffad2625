/// Data of a page's plots, which its script draws; web/src/plot_spec.js lists what a plot may hold.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

namespace castaway::testbed {

/// Values along an axis; nothing where there is none.
using PlotColumn = std::vector<std::optional<double>>;
/// Points (x, y).
using PlotPoints = std::vector<std::pair<double, double>>;

/// Numbers of this many significant digits; null for nothing and for what is not finite.
nlohmann::ordered_json plot_numbers(const PlotColumn& values, int digits = 3);

/// At most `most` values, an even number. Of longer columns each stretch keeps its smallest and its
/// largest value, in their order; nothing is smaller than any value, so gaps stay, too.
PlotColumn thin_column(const PlotColumn& values, std::size_t most);

/// Evenly spaced ones of the points, at most `most`.
PlotPoints every_few(const PlotPoints& points, std::size_t most);

/// A line over time, for a list of `series`: at most 2400 points. Its times are left out if they
/// are those of `shared`, the x of all.
nlohmann::ordered_json time_series(const std::string& name, const std::vector<double>& stamps_s,
                                   const PlotColumn& values, const nlohmann::ordered_json& shared);
/// The times of such a line.
nlohmann::ordered_json time_axis(const std::vector<double>& stamps_s);

/// A series of points of its own; `style` as in plot_spec.js, "" is a line.
nlohmann::ordered_json point_series(const std::string& name, const std::string& style,
                                    const PlotPoints& points);

/// JSON that cannot end the script element that it stands in.
std::string script_json(const nlohmann::ordered_json& json);

/// How plots stand in the page: below each other, or in pairs where there is room.
enum class PlotLayout { kWide, kPairs };

/// The empty element of plots and their data, {"x": ..., "plots": [...]}. Empty if the build has no
/// script to draw them.
std::string plots_html(const nlohmann::ordered_json& group, PlotLayout layout);

/// One sentence for readers who see no plots: those without JavaScript or, if the build has no
/// script, all.
std::string plots_notice();

}  // namespace castaway::testbed
