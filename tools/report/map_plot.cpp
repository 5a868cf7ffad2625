#include "tools/report/map_plot.hpp"

#include <cmath>
#include <functional>

#include <fmt/format.h>
#include <Eigen/Geometry>

#include "tools/report/html/html.hpp"
#include "tools/report/map_svg.hpp"

namespace castaway::testbed {
namespace {

using localization::SE2;

constexpr double kJump = 1.0;       // [m]
constexpr double kMapMargin = 1.0;  // [m] Around the paths if there is no map.

/// Poses of one kind in the rows of a curve.
struct Track {
  std::optional<SE2> ReportRow::*pose;
  std::optional<double> ReportRow::*z;
};

constexpr Track kTrue{&ReportRow::T_map_base_true, &ReportRow::z_true};
constexpr Track kEstimated{&ReportRow::T_map_base_estimate, &ReportRow::z_estimate};

/// True for the rows to be drawn on a floor.
using OnFloor = std::function<bool(std::optional<double> z)>;

/// An empty grid around all poses.
RosMap bounding_grid(const RunFolder& run) {
  Eigen::AlignedBox2d bounds;
  for (const ReportCurve& curve : run.curves) {
    for (const ReportRow& row : curve.rows) {
      for (const auto& pose : {row.T_map_base_true, row.T_map_base_estimate}) {
        if (pose) bounds.extend(pose->translation());
      }
    }
  }
  if (bounds.isEmpty()) bounds.extend(Eigen::Vector2d(0.0, 0.0));
  RosMap grid;
  grid.origin_x = bounds.min().x() - kMapMargin;
  grid.origin_y = bounds.min().y() - kMapMargin;
  grid.width = static_cast<int>(std::ceil((bounds.sizes().x() + 2 * kMapMargin) / grid.resolution));
  grid.height =
      static_cast<int>(std::ceil((bounds.sizes().y() + 2 * kMapMargin) / grid.resolution));
  return grid;
}

std::string path_data(const ReportCurve& curve, const Track& track, const RosMap& map,
                      const OnFloor& on_floor) {
  std::string path;
  std::optional<SE2> last;
  for (const ReportRow& row : curve.rows) {
    const std::optional<SE2>& pose = row.*track.pose;
    if (!pose) continue;
    if (!on_floor(row.*track.z)) {
      last.reset();
      continue;
    }
    const bool joined = last && localization::distance(*last, *pose) <= kJump;
    const Eigen::Vector2d p = map_pixel(map, pose->translation());
    path += fmt::format("{}{:.1f} {:.1f}", joined ? 'L' : 'M', p.x(), p.y());
    last = pose;
  }
  return path;
}

std::string path_element(const std::string& name, const std::string& style, const std::string& data,
                         double stroke) {
  return fmt::format("<path class=\"{}\" stroke-width=\"{:.2f}\" d=\"{}\"><title>{}</title></path>",
                     style, stroke, data, escape_html(name));
}

/// Draws the truth in black with a white rim, visible on walls and on free space.
std::string truth_element(const std::string& data, double stroke) {
  return fmt::format("<path class=\"path rim\" stroke-width=\"{:.2f}\" d=\"{}\"/>", 4.5 * stroke,
                     data) +
         path_element("truth", "path truth", data, 3.0 * stroke);
}

/// Draws the paths on one map.
std::string plot_on(const RunFolder& run, const RosMap& grid, bool drawn, const OnFloor& on_floor,
                    const std::string& label) {
  const double stroke = map_stroke(grid);
  std::string paths;
  if (!run.curves.empty()) {
    paths += truth_element(path_data(run.curves.front(), kTrue, grid, on_floor), stroke);
  }
  for (std::size_t i = 0; i < run.curves.size(); ++i) {
    const ReportCurve& curve = run.curves[i];
    paths += path_element(curve.localizer, fmt::format("path light c{}", i % 6),
                          path_data(curve, kEstimated, grid, on_floor), stroke);
  }
  return map_svg(grid, drawn, paths, label);
}

std::string plot_of_levels(const RunFolder& run, const LevelMaps& levels) {
  std::string html = "<div class=\"levels\">\n";
  for (std::size_t i = 0; i < levels.size(); ++i) {
    const auto on_floor = [&](std::optional<double> z) {
      return level_at(levels, z.value_or(0.0)) == i;
    };
    const std::string name = fmt::format("level {}: {:.2f} m", i, levels[i].z);
    html += fmt::format("<figure>{}<figcaption>{}</figcaption></figure>\n",
                        plot_on(run, levels[i].map, true, on_floor, "paths on " + name), name);
  }
  return html + "</div>\n";
}

}  // namespace

std::string render_map_plot(const RunFolder& run, const ReportMaps& maps) {
  if (!maps.levels.empty()) return plot_of_levels(run, maps.levels);
  const auto all = [](std::optional<double>) { return true; };
  const RosMap grid = maps.map ? *maps.map : bounding_grid(run);
  return plot_on(run, grid, maps.map.has_value(), all, "paths on the map");
}

}  // namespace castaway::testbed
