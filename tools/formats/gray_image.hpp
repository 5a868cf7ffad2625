/// Grey pictures: PGM (P2, P5, up to 16 bits, comments anywhere) and PNG.
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
};

/// Reads a PGM. `name` stands for the file in errors. Throws std::runtime_error on anything broken
/// or cut short.
GrayImage decode_pgm(std::string_view bytes, const std::string& name);

/// Reads a PNG: grey or the mean of the colours, 8 or 16 bits. Where it is not opaque, it is mixed
/// with white.
GrayImage decode_png_gray(std::string_view bytes, const std::string& name);

/// Reads a PGM or PNG file, told apart by their first bytes.
GrayImage load_gray_image(const std::filesystem::path& path);

/// The bytes of a binary PGM of 8 bits (`max_value` up to 255).
std::string encode_pgm(const GrayImage& image);

}  // namespace castaway::testbed
