#include "sim/render/image.hpp"

#include <fstream>
#include <stdexcept>

#include <fmt/format.h>
#include <png.h>

namespace castaway::sim {

std::string encode_png(const Image& image) {
  const auto bytes =
      3 * static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
  if (image.width <= 0 || image.height <= 0 || image.pixels.size() != bytes) {
    throw std::invalid_argument(fmt::format("picture of {} x {} px with {} bytes of colour",
                                            image.width, image.height, image.pixels.size()));
  }
  png_image header{};
  header.version = PNG_IMAGE_VERSION;
  header.format = PNG_FORMAT_RGB;
  header.width = static_cast<png_uint_32>(image.width);
  header.height = static_cast<png_uint_32>(image.height);
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(header);
  std::string png(size, '\0');
  if (png_image_write_to_memory(&header, png.data(), &size, 0, image.pixels.data(), 0, nullptr) ==
      0) {
    throw std::runtime_error(fmt::format("PNG encoder: {}", header.message));
  }
  png.resize(size);
  return png;
}

void write_png(const Image& image, const std::filesystem::path& path) {
  const std::string png = encode_png(image);
  std::ofstream file(path, std::ios::binary);
  file.write(png.data(), static_cast<std::streamsize>(png.size()));
  file.close();
  if (!file) {
    throw std::runtime_error(fmt::format(
        "{}: cannot write the picture; check that the folder exists, is writable and not full",
        path.string()));
  }
}

}  // namespace castaway::sim
