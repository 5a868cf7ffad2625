#include "tools/pages/twin/building_plot.hpp"

#include <array>

#include <fmt/format.h>

#include "tools/pages/run/map_svg.hpp"

namespace castaway::testbed {
namespace {

constexpr const char* kMovingStyle = "fill:#d0103a";
constexpr const char* kStandingStyle = "fill:none;stroke:#0072B2";
constexpr const char* kGoneStyle = "fill:none;stroke:#D55E00";
constexpr const char* kPathStyle = "fill:none;stroke:#009E73";

std::string path_on_map(const RosMap& map, const AlignedLog& log) {
  constexpr double kJump = 3.0;  // [m]
  std::string data;
  const SE2* before = nullptr;
  for (const AlignedScan& scan : log.scans) {
    const bool joined =
        before != nullptr && localization::distance(*before, scan.T_map_base) < kJump;
    const Eigen::Vector2d p = map_pixel(map, scan.T_map_base.translation());
    data += fmt::format("{}{:.1f} {:.1f}", joined ? 'L' : 'M', p.x(), p.y());
    before = &scan.T_map_base;
  }
  return fmt::format("<path style=\"{}\" stroke-width=\"{:.2f}\" d=\"{}\"/>", kPathStyle,
                     map_stroke(map), data);
}

std::string boxes_on_map(const RosMap& map, const std::vector<MapBox>& boxes, const char* style) {
  constexpr std::array<std::array<double, 2>, 4> kCorners{
      {{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}}};
  std::string svg;
  for (const MapBox& box : boxes) {
    std::string corners;
    for (const auto& [x, y] : kCorners) {
      const Eigen::Vector2d p_box(x * box.size.x(), y * box.size.y());
      const Eigen::Vector2d p = map_pixel(map, box.T_map_box * p_box);
      corners += fmt::format("{:.1f},{:.1f} ", p.x(), p.y());
    }
    svg += fmt::format("<polygon style=\"{}\" stroke-width=\"{:.2f}\" points=\"{}\"/>", style,
                       1.5 * map_stroke(map), corners);
  }
  return svg;
}

/// An entry of the legend: a coloured square and a text.
std::string legend_entry(const char* color, const char* text) {
  return fmt::format("<span><span style=\"color:{}\">&#9632;</span> {}</span>", color, text);
}

}  // namespace

std::string dots_on_map(const RosMap& map, const std::vector<Eigen::Vector2d>& points,
                        const char* style, double radius) {
  std::string svg = fmt::format("<g style=\"{}\">", style);
  for (const Eigen::Vector2d& point : points) {
    const Eigen::Vector2d p = map_pixel(map, point);
    svg += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{:.2f}\"/>", p.x(), p.y(),
                       radius * map_stroke(map));
  }
  return svg + "</g>";
}

std::string building_plot(const FittedLog& fitted, const RosMap& map) {
  std::string content = path_on_map(map, fitted.log);
  std::string legend = legend_entry("#009E73", "path");
  if (fitted.fit.building) {
    const BuildingFit& building = *fitted.fit.building;
    content += dots_on_map(map, building.moving_at, kMovingStyle, 0.8) +
               boxes_on_map(map, building.standing, kStandingStyle) +
               boxes_on_map(map, building.gone, kGoneStyle);
    legend += legend_entry("#d0103a", "beams that end at what moves") +
              legend_entry("#0072B2", "new objects") +
              legend_entry("#D55E00", "walls that are gone");
  }
  return "<p class=\"legend\">" + legend + "</p>\n" +
         map_svg(map, true, content, "path, moving and new objects on the map");
}

}  // namespace castaway::testbed
