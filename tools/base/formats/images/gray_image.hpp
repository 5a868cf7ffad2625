/// Grey images from PGM and PPM (P2, P3, P5, P6, up to 16 bits, comments anywhere), PNG, BMP and
/// JPEG.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace castaway::testbed {

/// A grey image.
struct GrayImage {
  int width = 0;
  int height = 0;
  int max_value = 255;                ///< White; black is 0.
  std::vector<std::uint16_t> pixels;  ///< Rows from the top; values up to `max_value`.
  std::vector<bool> transparent{};    ///< By pixel: true if it is not fully opaque. Empty if all
                                      ///< are opaque.
};

/// Larger images are rejected, since a run with people needs up to 70 bytes per cell.
inline constexpr std::int64_t kMostPixels = 28000000;

/// Throws std::runtime_error naming the file if an image has more than `kMostPixels`.
void refuse_large_picture(int width, int height, const std::string& name);

/// Decodes a PGM, or a PPM by the mean of its colours. `name` is the file's name in errors. Like
/// the other decoders, throws std::runtime_error on malformed or truncated data.
GrayImage decode_pgm(std::string_view bytes, const std::string& name);

/// Decodes a PNG of 8 or 16 bits by the mean of its colours.
GrayImage decode_png_gray(std::string_view bytes, const std::string& name);

/// Decodes an uncompressed BMP of 1, 4, 8, 24 or 32 bits by the mean of its colours.
GrayImage decode_bmp_gray(std::string_view bytes, const std::string& name);

/// Decodes a JPEG by its luminance.
GrayImage decode_jpeg_gray(std::string_view bytes, const std::string& name);

/// Reads an image whose format is detected from its first bytes.
GrayImage load_gray_image(const std::filesystem::path& path);

/// Encodes a binary PGM of 8 bits (`max_value` up to 255).
std::string encode_pgm(const GrayImage& image);

}  // namespace castaway::testbed
