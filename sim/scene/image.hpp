/// A colour picture, and its way into a PNG file.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace castaway::sim {

/// RGB, 8 bits a channel, row 0 at the top.
struct Image {
  int width = 0;                     ///< [px]
  int height = 0;                    ///< [px]
  std::vector<std::uint8_t> pixels;  ///< 3 * width * height: R, G, B of each pixel in rows.
};

/// The bytes of a PNG file; the same picture gives the same bytes. Throws std::invalid_argument if
/// the pixels do not fit the size.
std::string encode_png(const Image& image);

/// A picture of one channel of 16 bits, row 0 at the top.
struct DeepImage {
  int width = 0;                      ///< [px]
  int height = 0;                     ///< [px]
  std::vector<std::uint16_t> pixels;  ///< width * height.
};

/// The bytes of a 16-bit grey PNG file. Throws as the one above.
std::string encode_deep_png(const DeepImage& image);

}  // namespace castaway::sim
