/// Text in pictures: a font of 5 x 7 dots, printable ASCII.
#pragma once

#include <cstdint>
#include <string_view>

#include "sim/scene/image.hpp"

namespace castaway::testbed {

inline constexpr int kGlyphWidth = 5;    ///< [dots]
inline constexpr int kGlyphHeight = 7;   ///< [dots]
inline constexpr int kGlyphAdvance = 6;  ///< [dots] From a sign to the next.

/// A place in a picture, from its upper left corner. [px]
struct PixelPlace {
  int x = 0;
  int y = 0;
};

/// Of a text whose dots are `scale` px a side, without the gap behind its last sign. [px]
int text_width(std::string_view text, int scale);

/// Sets a pixel; outside of the picture nothing happens. `rgb`: 0xRRGGBB.
void set_pixel(sim::Image& image, PixelPlace at, std::uint32_t rgb);

/// Fills [x, x + width) x [y, y + height), as far as it lies in the picture.
void fill_box(sim::Image& image, PixelPlace at, PixelPlace size, std::uint32_t rgb);

/// Draws a text with its upper left corner at `at`. What is no printable ASCII is drawn as '?', a
/// sign of UTF-8 once.
void draw_text(sim::Image& image, PixelPlace at, std::string_view text, int scale,
               std::uint32_t rgb);

}  // namespace castaway::testbed
