#include <csetjmp>
#include <cstring>
#include <stdexcept>

#include <fmt/format.h>
#include <png.h>

#include "tools/base/formats/images/gray_image.hpp"

namespace castaway::testbed {
namespace {

constexpr png_uint_32 kMaxPngSide = 32768;

[[noreturn]] void fail(const std::string& name, const std::string& what) {
  throw std::runtime_error(fmt::format("{}: broken PNG: {}; copy the file again", name, what));
}

/// Grey values of rows of `channels` values of 8 or 16 bits; if `alpha`, the last channel is alpha.
template <typename Value>
std::vector<std::uint16_t> mean_of_channels(const std::vector<Value>& values, std::size_t channels,
                                            bool alpha) {
  const std::size_t colors = alpha ? channels - 1 : channels;
  std::vector<std::uint16_t> pixels;
  pixels.reserve(values.size() / channels);
  for (std::size_t i = 0; i < values.size(); i += channels) {
    std::uint64_t sum = 0;
    for (std::size_t c = 0; c < colors; ++c) sum += values[i + c];
    pixels.push_back(static_cast<std::uint16_t>((sum + colors / 2) / colors));
  }
  return pixels;
}

/// By pixel: true if the last channel is below the maximum. Empty if all pixels are opaque.
template <typename Value>
std::vector<bool> transparent_pixels(const std::vector<Value>& values, std::size_t channels) {
  std::vector<bool> result;
  bool any = false;
  result.reserve(values.size() / channels);
  for (std::size_t i = channels - 1; i < values.size(); i += channels) {
    result.push_back(values[i] != static_cast<Value>(-1));
    any = any || result.back();
  }
  return any ? result : std::vector<bool>{};
}

/// A PNG that is read with libpng's row interface, which returns the file's unmodified values.
struct PngState {
  explicit PngState(std::string_view data)
      : bytes(data),
        png(png_create_read_struct(PNG_LIBPNG_VER_STRING, this, on_error, on_warning)) {
    info = png_create_info_struct(png);
    png_set_read_fn(png, this, on_read);
    png_set_user_limits(png, kMaxPngSide, kMaxPngSide);
  }
  ~PngState() { png_destroy_read_struct(&png, &info, nullptr); }
  PngState(const PngState&) = delete;
  PngState& operator=(const PngState&) = delete;

  static void on_error(png_structp png, png_const_charp message) {
    static_cast<PngState*>(png_get_error_ptr(png))->error = message;
    png_longjmp(png, 1);
  }
  static void on_warning(png_structp, png_const_charp) {}
  static void on_read(png_structp png, png_bytep data, std::size_t length) {
    auto& state = *static_cast<PngState*>(png_get_io_ptr(png));
    if (length > state.bytes.size()) png_error(png, "cut short");
    std::memcpy(data, state.bytes.data(), length);
    state.bytes.remove_prefix(length);
  }

  std::string_view bytes;  // Bytes not yet read.
  png_structp png = nullptr;
  png_infop info = nullptr;
  std::string error;
  std::vector<std::uint8_t> pixels;
  std::vector<png_bytep> rows;
};

/// Returns false after a longjmp. Only state outside this frame changes after the setjmp.
bool read_size(PngState& state) {
  if (setjmp(png_jmpbuf(state.png)) != 0) return false;  // NOLINT: libpng's way of errors.
  png_read_info(state.png, state.info);
  return true;
}

bool read_pixels(PngState& state) {
  if (setjmp(png_jmpbuf(state.png)) != 0) return false;  // NOLINT: libpng's way of errors.
  png_set_expand(state.png);
  png_set_interlace_handling(state.png);
  png_read_update_info(state.png, state.info);
  state.pixels.resize(png_get_rowbytes(state.png, state.info) *
                      png_get_image_height(state.png, state.info));
  for (std::size_t at = 0; at < state.pixels.size();
       at += png_get_rowbytes(state.png, state.info)) {
    state.rows.push_back(state.pixels.data() + at);
  }
  png_read_image(state.png, state.rows.data());
  return true;
}

std::vector<std::uint16_t> wide_values(const std::vector<std::uint8_t>& bytes) {
  std::vector<std::uint16_t> values;
  values.reserve(bytes.size() / 2);
  for (std::size_t i = 0; i + 1 < bytes.size(); i += 2) {
    values.push_back(static_cast<std::uint16_t>(bytes[i] << 8U | bytes[i + 1]));
  }
  return values;
}

}  // namespace

GrayImage decode_png_gray(std::string_view bytes, const std::string& name) {
  PngState state(bytes);
  if (!read_size(state)) fail(name, state.error);
  refuse_large_picture(static_cast<int>(png_get_image_width(state.png, state.info)),
                       static_cast<int>(png_get_image_height(state.png, state.info)), name);
  if (!read_pixels(state)) fail(name, state.error);
  GrayImage image;
  image.width = static_cast<int>(png_get_image_width(state.png, state.info));
  image.height = static_cast<int>(png_get_image_height(state.png, state.info));
  const std::size_t channels = png_get_channels(state.png, state.info);
  const bool alpha = (png_get_color_type(state.png, state.info) & PNG_COLOR_MASK_ALPHA) != 0;
  const bool wide = png_get_bit_depth(state.png, state.info) == 16;
  image.max_value = wide ? 65535 : 255;
  const auto take = [&](const auto& values) {
    image.pixels = mean_of_channels(values, channels, alpha);
    if (alpha) image.transparent = transparent_pixels(values, channels);
  };
  if (wide) {
    take(wide_values(state.pixels));
  } else {
    take(state.pixels);
  }
  return image;
}

}  // namespace castaway::testbed
