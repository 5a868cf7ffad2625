/// Caption of a map image: clock, legend, scale bar.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "sim/scene/image.hpp"

namespace castaway::testbed {

/// Name and colour of an entry of the legend.
struct LegendEntry {
  std::string name;
  std::uint32_t rgb = 0;  ///< 0xRRGGBB
  bool ring = false;      ///< True for the truth's mark; otherwise a disc.
};

/// A caption for images of one size.
struct MapCaption {
  std::string clock;  ///< Such as "12.3 s"; empty for none.
  std::vector<LegendEntry> entries;
  double pixels_per_m = 0.0;  ///< Scale of the map above.
};

/// The longest of 1, 2, 5 times a power of ten that is at most `most` [m].
double round_length(double most);

/// Height [px] of the caption's strip at the bottom of an image; at most a third of the image.
int caption_height(const MapCaption& caption, int width, int height);

/// Draws a caption into the lowest `caption_height` rows of an image. Entries that do not fit are
/// counted ("+ 3 more").
void draw_caption(const MapCaption& caption, sim::Image& image);

}  // namespace castaway::testbed
