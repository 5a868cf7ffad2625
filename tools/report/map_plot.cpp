#include "tools/report/map_plot.hpp"

#include <cmath>

#include <fmt/format.h>
#include <Eigen/Geometry>

#include "tools/report/html/html.hpp"
#include "tools/report/map_svg.hpp"

namespace castaway::testbed {
namespace {

using localization::SE2;

constexpr double kJump = 1.0;       // [m]
constexpr double kMapMargin = 1.0;  // [m] Around the paths if there is no map.

using PoseOfRow = std::optional<SE2> ReportRow::*;

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

std::string path_data(const ReportCurve& curve, PoseOfRow pose_of, const RosMap& map) {
  std::string path;
  std::optional<SE2> last;
  for (const ReportRow& row : curve.rows) {
    const std::optional<SE2>& pose = row.*pose_of;
    if (!pose) continue;
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

}  // namespace

std::string render_map_plot(const RunFolder& run, const std::optional<RosMap>& map) {
  const RosMap bounding = map ? RosMap{} : bounding_grid(run);
  const RosMap& grid = map ? *map : bounding;
  const double stroke = map_stroke(grid);
  std::string paths;
  if (!run.curves.empty()) {
    paths +=
        truth_element(path_data(run.curves.front(), &ReportRow::T_map_base_true, grid), stroke);
  }
  for (std::size_t i = 0; i < run.curves.size(); ++i) {
    const ReportCurve& curve = run.curves[i];
    paths += path_element(curve.localizer, fmt::format("path light c{}", i % 6),
                          path_data(curve, &ReportRow::T_map_base_estimate, grid), stroke);
  }
  return map_svg(grid, map.has_value(), paths, "paths on the map");
}

}  // namespace castaway::testbed
