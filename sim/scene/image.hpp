/// Pictures and their encoding as PNG.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace castaway::sim {

/// RGB, 8 bits per channel, row 0 at the top.
struct Image {
  int width = 0;                     ///< [px]
  int height = 0;                    ///< [px]
  std::vector<std::uint8_t> pixels;  ///< 3 * width * height: R, G, B of each pixel in rows.
};

/// Returns the bytes of a PNG file; the same picture gives the same bytes. @throws
/// std::invalid_argument if the number of pixels does not fit the size.
std::string encode_png(const Image& image);

/// A picture with one channel of 16 bits, row 0 at the top.
struct DeepImage {
  int width = 0;                      ///< [px]
  int height = 0;                     ///< [px]
  std::vector<std::uint16_t> pixels;  ///< width * height.
};

/// Returns the bytes of a 16-bit grey PNG file. @throws as `encode_png`.
std::string encode_deep_png(const DeepImage& image);

}  // namespace castaway::sim
