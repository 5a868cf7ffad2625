#include "sim/scene/image.hpp"

#include <stdexcept>

#include <fmt/format.h>
#include <png.h>

namespace castaway::sim {

namespace {

void require_fit(int width, int height, std::size_t values, std::size_t channels) {
  const auto pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  if (width > 0 && height > 0 && values == channels * pixels) return;
  throw std::invalid_argument(
      fmt::format("picture of {} x {} px with {} values", width, height, values));
}

std::string encode(png_uint_32 format, int width, int height, const void* pixels) {
  png_image header{};
  header.version = PNG_IMAGE_VERSION;
  header.format = format;
  header.width = static_cast<png_uint_32>(width);
  header.height = static_cast<png_uint_32>(height);
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(header);
  std::string png(size, '\0');
  if (png_image_write_to_memory(&header, png.data(), &size, 0, pixels, 0, nullptr) == 0) {
    throw std::runtime_error(fmt::format("PNG encoder: {}", header.message));
  }
  png.resize(size);
  return png;
}

}  // namespace

std::string encode_png(const Image& image) {
  require_fit(image.width, image.height, image.pixels.size(), 3);
  return encode(PNG_FORMAT_RGB, image.width, image.height, image.pixels.data());
}

std::string encode_deep_png(const DeepImage& image) {
  require_fit(image.width, image.height, image.pixels.size(), 1);
  return encode(PNG_FORMAT_LINEAR_Y, image.width, image.height, image.pixels.data());
}

}  // namespace castaway::sim
