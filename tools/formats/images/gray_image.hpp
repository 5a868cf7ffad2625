/// Grey pictures: PGM and PPM (P2, P3, P5, P6, up to 16 bits, comments anywhere), PNG, BMP, JPEG.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace castaway::testbed {

/// A picture in grey.
struct GrayImage {
  int width = 0;
  int height = 0;
  int max_value = 255;                ///< White; black is 0.
  std::vector<std::uint16_t> pixels;  ///< Rows from the top; at most `max_value`.
  std::vector<bool> transparent{};    ///< By pixel: not wholly opaque. Empty: all are.
};

/// Larger pictures are refused: a run with people needs up to 70 bytes a cell.
inline constexpr std::int64_t kMostPixels = 28000000;

/// @throws std::runtime_error naming the file if a picture has more than `kMostPixels`.
void refuse_large_picture(int width, int height, const std::string& name);

/// Reads a PGM, or a PPM by the mean of its colours. `name` stands for the file in errors. Throws
/// std::runtime_error on anything broken or cut short, as the others do.
GrayImage decode_pgm(std::string_view bytes, const std::string& name);

/// Reads a PNG: grey or the mean of the colours, 8 or 16 bits.
GrayImage decode_png_gray(std::string_view bytes, const std::string& name);

/// Reads a BMP: 1, 4, 8, 24 or 32 bits, not compressed; the mean of the colours.
GrayImage decode_bmp_gray(std::string_view bytes, const std::string& name);

/// Reads a JPEG by its brightness.
GrayImage decode_jpeg_gray(std::string_view bytes, const std::string& name);

/// Reads a picture, whose format is told by its first bytes.
GrayImage load_gray_image(const std::filesystem::path& path);

/// The bytes of a binary PGM of 8 bits (`max_value` up to 255).
std::string encode_pgm(const GrayImage& image);

}  // namespace castaway::testbed
