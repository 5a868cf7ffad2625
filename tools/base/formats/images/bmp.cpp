#include <algorithm>
#include <array>
#include <cstdlib>
#include <stdexcept>

#include <fmt/format.h>

#include "tools/base/formats/images/gray_image.hpp"

namespace castaway::testbed {
namespace {

constexpr std::uint32_t kNoCompression = 0;
constexpr std::uint32_t kBitFields = 3;

/// Reads a Windows bitmap: a header, a palette, and rows from the bottom.
class BmpReader {
 public:
  BmpReader(std::string_view bytes, std::string name) : bytes_(bytes), name_(std::move(name)) {}

  GrayImage read() {
    read_header();
    GrayImage image;
    image.width = width_;
    image.height = std::abs(height_);
    refuse_large_picture(image.width, image.height, name_);
    const auto width = static_cast<std::size_t>(image.width);
    const std::size_t stride = (width * bits_ + 31) / 32 * 4;
    const auto rows = static_cast<std::size_t>(image.height);
    if (data_ > bytes_.size() || (bytes_.size() - data_) / stride < rows) {
      fail("cut short; copy the file again");
    }
    image.pixels.reserve(width * rows);
    for (std::size_t row = 0; row < rows; ++row) {
      const std::size_t line = data_ + stride * (height_ < 0 ? row : rows - 1 - row);
      for (std::size_t column = 0; column < width; ++column) {
        image.pixels.push_back(pixel(line, column));
      }
    }
    return image;
  }

 private:
  [[noreturn]] void fail(const std::string& what) const {
    throw std::runtime_error(fmt::format("{}: broken BMP: {}", name_, what));
  }

  [[nodiscard]] std::uint32_t number(std::size_t at, std::size_t size) const {
    if (at + size > bytes_.size()) fail("cut short; copy the file again");
    std::uint32_t value = 0;
    for (std::size_t i = size; i-- > 0;) {
      value = value << 8U | static_cast<std::uint8_t>(bytes_[at + i]);
    }
    return value;
  }

  void read_header() {
    data_ = number(10, 4);
    const std::uint32_t header = number(14, 4);
    if (header < 40) fail("its header is older than Windows 3; save it as PNG");
    width_ = static_cast<int>(number(18, 4));
    height_ = static_cast<int>(number(22, 4));
    bits_ = number(28, 2);
    check_format(number(30, 4));
    if (bits_ <= 8) read_palette(14 + header);
  }

  void check_format(std::uint32_t compression) const {
    constexpr std::array<std::size_t, 5> kDepths{1, 4, 8, 24, 32};
    const bool plain = compression == kNoCompression || (compression == kBitFields && bits_ == 32);
    if (!plain) fail("it is compressed; save it as PNG");
    if (std::find(kDepths.begin(), kDepths.end(), bits_) == kDepths.end()) {
      fail(fmt::format("{} bits per pixel are not supported; save it as PNG", bits_));
    }
    if (width_ <= 0 || height_ == 0 || height_ == INT32_MIN) fail("it has no pixels");
  }

  void read_palette(std::size_t at) {
    std::uint32_t colors = number(46, 4);
    if (colors == 0 || colors > 1U << bits_) colors = 1U << bits_;
    for (std::uint32_t i = 0; i < colors; ++i) palette_.push_back(mean(at + 4 * i));
  }

  /// Mean of blue, green and red.
  [[nodiscard]] std::uint16_t mean(std::size_t at) const {
    const std::uint32_t sum = number(at, 1) + number(at + 1, 1) + number(at + 2, 1);
    return static_cast<std::uint16_t>((sum + 1) / 3);
  }

  [[nodiscard]] std::uint16_t pixel(std::size_t line, std::size_t column) const {
    if (bits_ > 8) return mean(line + column * (bits_ / 8));
    const std::size_t per_byte = 8 / bits_;
    const std::uint32_t byte = number(line + column / per_byte, 1);
    const std::size_t shift = (per_byte - 1 - column % per_byte) * bits_;
    const std::uint32_t index = byte >> shift & ((1U << bits_) - 1);
    if (index >= palette_.size()) fail("a pixel is beyond the palette");
    return palette_[index];
  }

  std::string_view bytes_;
  std::string name_;
  std::size_t data_ = 0;
  std::size_t bits_ = 0;
  int width_ = 0;
  int height_ = 0;  ///< Negative: rows from the top.
  std::vector<std::uint16_t> palette_;
};

}  // namespace

GrayImage decode_bmp_gray(std::string_view bytes, const std::string& name) {
  return BmpReader(bytes, name).read();
}

}  // namespace castaway::testbed
