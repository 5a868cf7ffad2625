#include "tools/base/formats/images/gray_image.hpp"

#include <stdexcept>

#include <fmt/format.h>

#include "tools/base/files/file.hpp"

namespace castaway::testbed {

void refuse_large_picture(int width, int height, const std::string& name) {
  const auto pixels = static_cast<std::int64_t>(width) * height;
  if (pixels <= kMostPixels) return;
  throw std::runtime_error(fmt::format(
      "{}: {} x {} pixels: at most {} million are read; crop it, or save it with larger cells",
      name, width, height, kMostPixels / 1000000));
}

GrayImage load_gray_image(const std::filesystem::path& path) {
  const std::string bytes = read_file(path);
  const std::string name = path.string();
  if (bytes.starts_with("\x89PNG")) return decode_png_gray(bytes, name);
  if (bytes.starts_with("\xff\xd8\xff")) return decode_jpeg_gray(bytes, name);
  if (bytes.starts_with("BM")) return decode_bmp_gray(bytes, name);
  for (const char* magic : {"P2", "P3", "P5", "P6"}) {
    if (bytes.starts_with(magic)) return decode_pgm(bytes, name);
  }
  throw std::runtime_error(
      name + ": neither PNG, PGM, PPM, BMP nor JPEG; convert it, e.g. `convert in out.png`");
}

}  // namespace castaway::testbed
