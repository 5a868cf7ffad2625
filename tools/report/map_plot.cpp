#include "tools/report/map_plot.hpp"

#include <cmath>

#include <fmt/format.h>
#include <Eigen/Geometry>

#include "sim/render/image.hpp"
#include "tools/report/html.hpp"

namespace castaway::testbed {
namespace {

using localization::SE2;

constexpr double kJump = 1.0;    // [m]
constexpr double kMargin = 1.0;  // [m] Around paths without a map.

using PoseOfRow = std::optional<SE2> ReportRow::*;

/// The grid alone, around all poses.
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
  grid.origin_x = bounds.min().x() - kMargin;
  grid.origin_y = bounds.min().y() - kMargin;
  grid.width = static_cast<int>(std::ceil((bounds.sizes().x() + 2 * kMargin) / grid.resolution));
  grid.height = static_cast<int>(std::ceil((bounds.sizes().y() + 2 * kMargin) / grid.resolution));
  return grid;
}

std::string map_png(const RosMap& map) {
  const GrayImage gray = map_image(map);
  sim::Image image{map.width, map.height, {}};
  image.pixels.reserve(3 * gray.pixels.size());
  for (const std::uint16_t pixel : gray.pixels) {
    image.pixels.insert(image.pixels.end(), 3, static_cast<std::uint8_t>(pixel));
  }
  return sim::encode_png(image);
}

/// Pixels of the picture, x right, y down.
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

}  // namespace

std::string render_map_plot(const RunFolder& run, const std::optional<RosMap>& map) {
  const RosMap grid = map ? *map : bounding_grid(run);
  const double stroke = std::max(grid.width, grid.height) / 400.0;
  std::string svg = fmt::format(
      "<svg class=\"map\" viewBox=\"0 0 {0} {1}\" role=\"img\" aria-label=\"paths on the map\">",
      grid.width, grid.height);
  if (map) {
    svg += fmt::format("<image width=\"{}\" height=\"{}\" href=\"{}\"/>", grid.width, grid.height,
                       png_data_uri(map_png(*map)));
  }
  if (!run.curves.empty()) {
    svg += path_element("truth", "path truth",
                        path_data(run.curves.front(), &ReportRow::T_map_base_true, grid),
                        2.2 * stroke);
  }
  for (std::size_t i = 0; i < run.curves.size(); ++i) {
    const ReportCurve& curve = run.curves[i];
    svg += path_element(curve.localizer, fmt::format("path light c{}", i % 6),
                        path_data(curve, &ReportRow::T_map_base_estimate, grid), stroke);
  }
  return svg + "</svg>\n";
}

}  // namespace castaway::testbed
