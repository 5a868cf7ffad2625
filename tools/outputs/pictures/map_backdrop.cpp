#include "tools/outputs/pictures/map_backdrop.hpp"

#include <algorithm>
#include <utility>

namespace castaway::testbed {
namespace {

int ratio_up(int a, int b) { return (a + b - 1) / b; }

}  // namespace

sim::Image map_backdrop(const RosMap& map) {
  const GrayImage cells = map_image(map);
  const int n = std::max(1, ratio_up(std::max(map.width, map.height), kMostBackdropPixels));
  sim::Image image{ratio_up(map.width, n), ratio_up(map.height, n), {}};
  std::vector<std::uint8_t> darkest(static_cast<std::size_t>(image.width), 255);
  for (int row = 0; row < map.height; ++row) {
    for (int column = 0; column < map.width; ++column) {
      const auto at = static_cast<std::size_t>(row) * static_cast<std::size_t>(map.width) +
                      static_cast<std::size_t>(column);
      auto& pixel = darkest[static_cast<std::size_t>(column / n)];
      pixel = std::min(pixel, static_cast<std::uint8_t>(cells.pixels[at]));
    }
    if ((row + 1) % n != 0 && row + 1 < map.height) continue;
    for (std::uint8_t& pixel : darkest) {
      image.pixels.insert(image.pixels.end(), 3, std::exchange(pixel, std::uint8_t{255}));
    }
  }
  return image;
}

}  // namespace castaway::testbed
