#include <csetjmp>
#include <cstdio>
#include <stdexcept>

#include <fmt/format.h>
#include <jpeglib.h>

#include "tools/base/formats/images/gray_image.hpp"

namespace castaway::testbed {
namespace {

/// State of the decoder. Errors and warnings, such as truncation, leave by longjmp.
struct JpegState {
  JpegState() {
    jpeg.err = jpeg_std_error(&errors);
    errors.error_exit = on_error;
    errors.emit_message = on_message;
    jpeg.client_data = this;
    jpeg_create_decompress(&jpeg);
  }
  ~JpegState() { jpeg_destroy_decompress(&jpeg); }
  JpegState(const JpegState&) = delete;
  JpegState& operator=(const JpegState&) = delete;

  static void on_error(j_common_ptr info) {
    auto& state = *static_cast<JpegState*>(info->client_data);
    info->err->format_message(info, state.error);
    std::longjmp(state.jump, 1);
  }
  static void on_message(j_common_ptr info, int level) {
    if (level < 0) on_error(info);
  }

  jpeg_decompress_struct jpeg{};
  jpeg_error_mgr errors{};
  std::jmp_buf jump{};
  char error[JMSG_LENGTH_MAX] = "";
  std::vector<std::uint8_t> row;
};

/// Returns false after a longjmp. Only state outside this frame changes after the setjmp.
bool read_header(JpegState& state, std::string_view bytes) {
  if (setjmp(state.jump) != 0) return false;  // NOLINT: libjpeg's way of errors.
  jpeg_mem_src(&state.jpeg, reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size());
  jpeg_read_header(&state.jpeg, TRUE);
  return true;
}

bool read_rows(JpegState& state, GrayImage& image) {
  if (setjmp(state.jump) != 0) return false;  // NOLINT: libjpeg's way of errors.
  state.jpeg.out_color_space = JCS_GRAYSCALE;
  jpeg_start_decompress(&state.jpeg);
  state.row.resize(state.jpeg.output_width);
  while (state.jpeg.output_scanline < state.jpeg.output_height) {
    JSAMPROW row = state.row.data();
    jpeg_read_scanlines(&state.jpeg, &row, 1);
    image.pixels.insert(image.pixels.end(), state.row.begin(), state.row.end());
  }
  jpeg_finish_decompress(&state.jpeg);
  return true;
}

}  // namespace

GrayImage decode_jpeg_gray(std::string_view bytes, const std::string& name) {
  JpegState state;
  GrayImage image;
  const auto fail = [&] {
    throw std::runtime_error(
        fmt::format("{}: broken JPEG: {}; copy the file again", name, state.error));
  };
  if (!read_header(state, bytes)) fail();
  image.width = static_cast<int>(state.jpeg.image_width);
  image.height = static_cast<int>(state.jpeg.image_height);
  refuse_large_picture(image.width, image.height, name);
  image.pixels.reserve(static_cast<std::size_t>(image.width) *
                       static_cast<std::size_t>(image.height));
  if (!read_rows(state, image)) fail();
  return image;
}

}  // namespace castaway::testbed
