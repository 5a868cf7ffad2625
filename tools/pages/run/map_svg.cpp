#include "tools/pages/run/map_svg.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <Eigen/Geometry>

#include "sim/scene/image.hpp"
#include "tools/base/formats/html.hpp"
#include "tools/outputs/pictures/map_backdrop.hpp"
#include "tools/outputs/pictures/map_caption.hpp"

namespace castaway::testbed {
namespace {

/// Position in the grid. [cells]
Eigen::Vector2d in_cells(const RosMap& map, const Eigen::Vector2d& p_map) {
  const Eigen::Vector2d from_origin = p_map - Eigen::Vector2d(map.origin_x, map.origin_y);
  return Eigen::Rotation2Dd(-map.origin_yaw) * from_origin / map.resolution;
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

}  // namespace

Eigen::Vector2d map_pixel(const RosMap& map, const Eigen::Vector2d& p_map) {
  const Eigen::Vector2d cells = in_cells(map, p_map);
  return {cells.x(), map.height - cells.y()};
}

double map_stroke(const RosMap& map) { return std::max(map.width, map.height) / 400.0; }

std::string map_svg(const RosMap& map, bool drawn, const std::string& content,
                    const std::string& label) {
  const double stroke = map_stroke(map);
  std::string svg =
      fmt::format("<svg class=\"map\" viewBox=\"0 0 {} {:.1f}\" role=\"img\" aria-label=\"{}\">",
                  map.width, map.height + 11.0 * stroke, escape_html(label));
  if (drawn) {
    svg += fmt::format("<image width=\"{}\" height=\"{}\" href=\"{}\"/>", map.width, map.height,
                       png_data_uri(sim::encode_png(map_backdrop(map))));
  }
  return svg + content + scale_bar(map, stroke) + "</svg>\n";
}

RosMap cut_out(const RosMap& map, const Eigen::Vector2d& p_map, double reach) {
  const Eigen::Vector2d centre = in_cells(map, p_map);
  const double cells = reach / map.resolution;
  const auto clamp = [](double cell, int size) {
    return std::clamp(static_cast<int>(std::floor(cell)), 0, size);
  };
  const int left = clamp(centre.x() - cells, map.width - 1);
  const int low = clamp(centre.y() - cells, map.height - 1);
  return part_of(map, {left, low},
                 {std::max(clamp(centre.x() + cells, map.width) - left, 1),
                  std::max(clamp(centre.y() + cells, map.height) - low, 1)});
}

}  // namespace castaway::testbed
