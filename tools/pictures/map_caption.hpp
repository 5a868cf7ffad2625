/// What stands beneath a picture of a map: clock, legend, scale bar.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "sim/scene/image.hpp"

namespace castaway::testbed {

/// Who has which colour on the map.
struct LegendEntry {
  std::string name;
  std::uint32_t rgb = 0;  ///< 0xRRGGBB
  bool ring = false;      ///< The truth's mark; else a disc.
};

/// A caption for pictures of one size.
struct MapCaption {
  std::string clock;  ///< "12.3 s"; empty: none.
  std::vector<LegendEntry> entries;
  double pixels_per_m = 0.0;  ///< Of the map above.
};

/// The longest of 1, 2, 5 times a power of ten that is no longer than `most`. [m]
double round_length(double most);

/// Of the strip that a caption takes at the bottom of a picture; at most a third of it. [px]
int caption_height(const MapCaption& caption, int width, int height);

/// Fills the lowest `caption_height` rows of a picture. What finds no place is counted
/// ("+ 3 more").
void draw_caption(const MapCaption& caption, sim::Image& image);

}  // namespace castaway::testbed
