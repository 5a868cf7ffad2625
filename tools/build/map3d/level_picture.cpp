#include "tools/build/map3d/level_picture.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include <fmt/format.h>

#include "tools/outputs/pictures/bitmap_text.hpp"

namespace castaway::testbed {
namespace {

using localization::ElevationMap;
using localization::GroundSurface;

constexpr int kWidest = 1600;  // [px]
constexpr int kMargin = 12;    // [px]
constexpr int kCaption = 20;   // [px]
constexpr std::uint32_t kWhite = 0xffffff;
constexpr std::uint32_t kText = 0x333333;
constexpr std::uint32_t kObstacle = 0x4a4f55;

/// Where things are in the picture.
struct Layout {
  int panel_width = 0;   ///< [px]
  int panel_height = 0;  ///< [px]
  int cells = 1;         ///< Along a pixel's edge.
};

Layout layout_of(const ElevationMap& map) {
  const int count = static_cast<int>(map.levels.size());
  const int room = std::max(1, kWidest / count - kMargin);
  Layout layout;
  layout.cells = std::max(1, (map.frame.width + room - 1) / room);
  layout.panel_width = (map.frame.width + layout.cells - 1) / layout.cells;
  layout.panel_height = (map.frame.height + layout.cells - 1) / layout.cells;
  return layout;
}

/// Light comes from the north-west, as on printed maps.
std::uint32_t shade(const GroundSurface& surface) {
  const double light = 0.9 + 0.9 * static_cast<double>(surface.slope_x - surface.slope_y);
  const auto channel = [&](double full) {
    return static_cast<std::uint32_t>(std::clamp(light * full, 0.0, 255.0));
  };
  return channel(236.0) << 16U | channel(226.0) << 8U | channel(205.0);
}

/// Colour of a cell on a level; white if the level has no surface there.
std::uint32_t color_of(const ElevationMap& map, const Eigen::Vector2i& cell, std::size_t level) {
  std::uint32_t color = kWhite;
  for (const GroundSurface& surface : map.at(cell)) {
    if (surface.level != level) continue;
    if (surface.drivable) return shade(surface);
    color = kObstacle;
  }
  return color;
}

void draw_panel(const ElevationMap& map, std::size_t level, const Layout& layout,
                sim::Image& image) {
  const int left = kMargin + static_cast<int>(level) * (layout.panel_width + kMargin);
  draw_text(image, {left, (kCaption - kGlyphHeight) / 2},
            fmt::format("level {}: {:.2f} m", level, map.levels[level]), 1, kText);
  for (int y = 0; y < layout.panel_height; ++y) {
    for (int x = 0; x < layout.panel_width; ++x) {
      const Eigen::Vector2i cell(x * layout.cells, y * layout.cells);
      set_pixel(image, {left + x, kCaption + layout.panel_height - 1 - y},
                color_of(map, cell, level));
    }
  }
}

}  // namespace

sim::Image level_picture(const ElevationMap& map) {
  const Layout layout = layout_of(map);
  const int count = static_cast<int>(map.levels.size());
  sim::Image image;
  image.width = kMargin + count * (layout.panel_width + kMargin);
  image.height = kCaption + layout.panel_height + kMargin;
  image.pixels.assign(
      3 * static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height), 255);
  for (std::size_t level = 0; level < map.levels.size(); ++level) {
    draw_panel(map, level, layout, image);
  }
  return image;
}

}  // namespace castaway::testbed
