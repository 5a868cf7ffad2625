/// Data of a page's plots, drawn by its script; web/src/plot_spec.js documents the format.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

namespace castaway::testbed {

/// Values along an axis; nothing for a gap.
using PlotColumn = std::vector<std::optional<double>>;
/// Points (x, y).
using PlotPoints = std::vector<std::pair<double, double>>;

/// Rounds numbers to this many significant digits; null for gaps and values that are not finite.
nlohmann::ordered_json plot_numbers(const PlotColumn& values, int digits = 3);

/// Thins a column to at most `most` values, an even number. Each stretch of a longer column keeps
/// its minimum and maximum in their order. A gap counts as less than any value, so gaps are kept.
PlotColumn thin_column(const PlotColumn& values, std::size_t most);

/// At most `most` evenly spaced points.
PlotPoints every_few(const PlotPoints& points, std::size_t most);

/// The cumulative distribution of ascending samples, as at most 300 points.
PlotPoints cumulative(const std::vector<double>& samples);

/// A line over time for a list of `series`, with at most 2400 points. Its times are omitted if they
/// equal `shared`, the common x of all series.
nlohmann::ordered_json time_series(const std::string& name, const std::vector<double>& stamps_s,
                                   const PlotColumn& values, const nlohmann::ordered_json& shared);
/// The times of such a line.
nlohmann::ordered_json time_axis(const std::vector<double>& stamps_s);

/// A series with its own points; `style` as in plot_spec.js, "" for a line.
nlohmann::ordered_json point_series(const std::string& name, const std::string& style,
                                    const PlotPoints& points);

/// JSON that cannot terminate the script element that contains it.
std::string script_json(const nlohmann::ordered_json& json);

/// Layout of plots in the page: below each other, or in pairs if there is room.
enum class PlotLayout { kWide, kPairs };

/// The empty element of the plots with their data, {"x": ..., "plots": [...]}. Empty if the build
/// has no script to draw them.
std::string plots_html(const nlohmann::ordered_json& group, PlotLayout layout);

/// One sentence for readers who see no plots: those without JavaScript, or all if the build has no
/// script.
std::string plots_notice();

}  // namespace castaway::testbed
