/// Text in images: a font of 5 x 7 dots for printable ASCII.
#pragma once

#include <cstdint>
#include <string_view>

#include "sim/scene/image.hpp"

namespace castaway::testbed {

inline constexpr int kGlyphWidth = 5;    ///< [dots]
inline constexpr int kGlyphHeight = 7;   ///< [dots]
inline constexpr int kGlyphAdvance = 6;  ///< [dots] From one character to the next.

/// A position [px] in an image, from its upper left corner.
struct PixelPlace {
  int x = 0;
  int y = 0;
};

/// Width [px] of a text with dots of `scale` px, without the gap after its last character.
int text_width(std::string_view text, int scale);

/// Sets a pixel; positions outside the image are ignored. `rgb`: 0xRRGGBB.
void set_pixel(sim::Image& image, PixelPlace at, std::uint32_t rgb);

/// Fills the part of [x, x + width) x [y, y + height) that lies in the image.
void fill_box(sim::Image& image, PixelPlace at, PixelPlace size, std::uint32_t rgb);

/// Draws a text with its upper left corner at `at`. Every character that is not printable ASCII is
/// drawn as one '?'.
void draw_text(sim::Image& image, PixelPlace at, std::string_view text, int scale,
               std::uint32_t rgb);

}  // namespace castaway::testbed
