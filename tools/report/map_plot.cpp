#include "tools/report/map_plot.hpp"

#include <cmath>

#include <fmt/format.h>
#include <Eigen/Geometry>

#include "sim/scene/image.hpp"
#include "tools/pictures/map_backdrop.hpp"
#include "tools/pictures/map_caption.hpp"
#include "tools/report/html/html.hpp"

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

/// Position in the image [px], x right, y down.
Eigen::Vector2d on_picture(const RosMap& map, const SE2& T_map_base) {
  const Eigen::Vector2d from_origin =
      T_map_base.translation() - Eigen::Vector2d(map.origin_x, map.origin_y);
  const Eigen::Vector2d cells = Eigen::Rotation2Dd(-map.origin_yaw) * from_origin / map.resolution;
  return {cells.x(), map.height - cells.y()};
}

std::string path_data(const ReportCurve& curve, PoseOfRow pose_of, const RosMap& map) {
  std::string path;
  std::optional<SE2> last;
  for (const ReportRow& row : curve.rows) {
    const std::optional<SE2>& pose = row.*pose_of;
    if (!pose) continue;
    const bool joined = last && localization::distance(*last, *pose) <= kJump;
    const Eigen::Vector2d p = on_picture(map, *pose);
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

/// Draws a scale bar of a round length below the map, at its right.
std::string scale_bar(const RosMap& grid, double stroke) {
  const double metres = round_length(0.2 * grid.width * grid.resolution);
  const double length = metres / grid.resolution;
  const double y = grid.height + 8.0 * stroke;
  return fmt::format(
      "<path class=\"scale\" stroke-width=\"{:.2f}\" d=\"M{:.1f} {:.1f}v{:.1f}h{:.1f}v{:.1f}\"/>"
      "<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"end\" style=\"font-size:{:.1f}px\">{:g} m"
      "</text>",
      stroke, grid.width - length - stroke, y - 3.0 * stroke, 3.0 * stroke, length, -3.0 * stroke,
      grid.width - length - 4.0 * stroke, y, 8.0 * stroke, metres);
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
  const double stroke = std::max(grid.width, grid.height) / 400.0;
  std::string svg = fmt::format(
      "<svg class=\"map\" viewBox=\"0 0 {} {:.1f}\" role=\"img\" aria-label=\"paths on the map\">",
      grid.width, grid.height + 11.0 * stroke);
  if (map) {
    svg += fmt::format("<image width=\"{}\" height=\"{}\" href=\"{}\"/>", grid.width, grid.height,
                       png_data_uri(sim::encode_png(map_backdrop(*map))));
  }
  if (!run.curves.empty()) {
    svg += truth_element(path_data(run.curves.front(), &ReportRow::T_map_base_true, grid), stroke);
  }
  for (std::size_t i = 0; i < run.curves.size(); ++i) {
    const ReportCurve& curve = run.curves[i];
    svg += path_element(curve.localizer, fmt::format("path light c{}", i % 6),
                        path_data(curve, &ReportRow::T_map_base_estimate, grid), stroke);
  }
  return svg + scale_bar(grid, stroke) + "</svg>\n";
}

}  // namespace castaway::testbed
