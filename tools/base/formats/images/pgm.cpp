#include <cassert>
#include <charconv>
#include <stdexcept>

#include <fmt/format.h>

#include "tools/base/formats/images/gray_image.hpp"

namespace castaway::testbed {
namespace {

constexpr int kMaxSide = 32768;  // 1.6 km at 5 cm.

bool is_space(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

/// Consumes the tokens of a PGM from the front.
class PgmReader {
 public:
  PgmReader(std::string_view bytes, std::string name) : bytes_(bytes), name_(std::move(name)) {}

  GrayImage read() {
    const std::string_view magic = bytes_.substr(0, 2);
    const bool text = magic == "P2" || magic == "P3";
    channels_ = magic == "P3" || magic == "P6" ? 3 : 1;
    if (!text && magic != "P5" && magic != "P6") {
      fail("no PGM or PPM; it must begin with P2, P3, P5 or P6");
    }
    at_ = 2;
    GrayImage image;
    image.width = number("width", 1, kMaxSide);
    image.height = number("height", 1, kMaxSide);
    image.max_value = number("largest value", 1, 65535);
    refuse_large_picture(image.width, image.height, name_);
    const auto count =
        static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
    if (text) {
      read_text(count, image);
    } else {
      read_binary(count, image);
    }
    return image;
  }

 private:
  [[noreturn]] void fail(const std::string& what) const {
    throw std::runtime_error(fmt::format("{}: {}", name_, what));
  }

  void skip_blanks_and_comments() {
    while (at_ < bytes_.size() && (is_space(bytes_[at_]) || bytes_[at_] == '#')) {
      if (bytes_[at_] == '#') at_ = std::min(bytes_.find('\n', at_), bytes_.size() - 1);
      ++at_;
    }
  }

  int number(const char* what, int least, int most) {
    skip_blanks_and_comments();
    const char* begin = bytes_.data() + at_;
    const char* end = bytes_.data() + bytes_.size();
    if (begin == end) fail(fmt::format("cut short before its {}; copy the file again", what));
    int value = 0;
    const auto [stop, error] = std::from_chars(begin, end, value);
    if (error != std::errc{} || value < least || value > most) {
      fail(fmt::format("its {} at byte {} is no number from {} to {}", what, at_, least, most));
    }
    at_ += static_cast<std::size_t>(stop - begin);
    return value;
  }

  void read_binary(std::size_t count, GrayImage& image) {
    ++at_;  // One white space follows the maximum value.
    const std::size_t width = image.max_value > 255 ? 2 : 1;
    const std::size_t pixel = width * static_cast<std::size_t>(channels_);
    if (at_ > bytes_.size() || (bytes_.size() - at_) / pixel < count) {
      fail(fmt::format("cut short: {} of {} bytes of pixels; copy the file again",
                       bytes_.size() - std::min(at_, bytes_.size()), count * pixel));
    }
    image.pixels.reserve(count);
    const auto next = [&] {
      int value = static_cast<std::uint8_t>(bytes_[at_]);
      if (width == 2) value = value * 256 + static_cast<std::uint8_t>(bytes_[at_ + 1]);
      if (value > image.max_value) fail("a pixel is above the largest value");
      at_ += width;
      return value;
    };
    while (image.pixels.size() < count) image.pixels.push_back(mean_of(next));
  }

  /// Mean of a pixel's channels.
  template <typename Next>
  [[nodiscard]] std::uint16_t mean_of(Next next) const {
    int sum = 0;
    for (int i = 0; i < channels_; ++i) sum += next();
    return static_cast<std::uint16_t>((sum + channels_ / 2) / channels_);
  }

  void read_text(std::size_t count, GrayImage& image) {
    if ((bytes_.size() - at_) / 2 / static_cast<std::size_t>(channels_) < count) {
      fail(fmt::format("cut short: it cannot hold {} pixels; copy the file again", count));
    }
    image.pixels.reserve(count);
    const auto next = [&] { return number("pixel", 0, image.max_value); };
    while (image.pixels.size() < count) image.pixels.push_back(mean_of(next));
  }

  std::string_view bytes_;
  std::string name_;
  int channels_ = 1;
  std::size_t at_ = 0;
};

}  // namespace

GrayImage decode_pgm(std::string_view bytes, const std::string& name) {
  return PgmReader(bytes, name).read();
}

std::string encode_pgm(const GrayImage& image) {
  assert(image.max_value <= 255);
  std::string bytes = fmt::format("P5\n{} {}\n{}\n", image.width, image.height, image.max_value);
  bytes.reserve(bytes.size() + image.pixels.size());
  for (const std::uint16_t pixel : image.pixels) bytes += static_cast<char>(pixel);
  return bytes;
}

}  // namespace castaway::testbed
