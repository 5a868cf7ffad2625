#include "sim/scene/image.hpp"

#include <gtest/gtest.h>
#include <png.h>

namespace castaway::sim {
namespace {

Image two_pixels() { return {2, 1, {255, 0, 0, 0, 128, 255}}; }

TEST(Image, SurvivesPng) {
  const std::string png = encode_png(two_pixels());
  png_image header{};
  header.version = PNG_IMAGE_VERSION;
  ASSERT_NE(png_image_begin_read_from_memory(&header, png.data(), png.size()), 0);
  header.format = PNG_FORMAT_RGB;
  ASSERT_EQ(header.width, 2U);
  ASSERT_EQ(header.height, 1U);
  std::vector<std::uint8_t> pixels(6);
  ASSERT_NE(png_image_finish_read(&header, nullptr, pixels.data(), 0, nullptr), 0);
  EXPECT_EQ(pixels, two_pixels().pixels);
}

TEST(Image, HasTheSameBytesEachTimeAndNoTime) {
  const std::string png = encode_png(two_pixels());
  EXPECT_EQ(png, encode_png(two_pixels()));
  EXPECT_EQ(png.find("tIME"), std::string::npos);
}

TEST(Image, RefusesPixelsThatDoNotFit) {
  EXPECT_THROW(encode_png({2, 2, {1, 2, 3}}), std::invalid_argument);
  EXPECT_THROW(encode_png({}), std::invalid_argument);
}

}  // namespace
}  // namespace castaway::sim
