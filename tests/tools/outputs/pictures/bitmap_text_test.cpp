#include "tools/outputs/pictures/bitmap_text.hpp"

#include <string>

#include <gtest/gtest.h>

namespace castaway::testbed {
namespace {

sim::Image black(int width, int height) {
  const auto values = static_cast<std::size_t>(3 * width * height);
  return {width, height, std::vector<std::uint8_t>(values, 0)};
}

/// '#' for pixels with red set, rows separated by '/'.
std::string drawn(const sim::Image& image) {
  std::string text;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      text += image.pixels[static_cast<std::size_t>(3 * (y * image.width + x))] > 0 ? '#' : '.';
    }
    text += '/';
  }
  return text;
}

TEST(BitmapText, DrawsSignsAsTheyLook) {
  sim::Image image = black(11, 7);
  draw_text(image, {0, 0}, "1m", 1, 0xFFFFFF);
  EXPECT_EQ(drawn(image),
            "..#......../"
            ".##......../"
            "..#...##.#./"
            "..#...#.#.#/"
            "..#...#.#.#/"
            "..#...#...#/"
            ".###..#...#/");
}

TEST(BitmapText, ScalesDots) {
  sim::Image image = black(10, 14);
  draw_text(image, {0, 0}, "-", 2, 0xFF0000);
  EXPECT_EQ(drawn(image).substr(6 * 11, 22), "##########/##########/");
  EXPECT_EQ(image.pixels[3 * 60 + 1], 0);  // The green channel.
}

TEST(BitmapText, IsAsWideAsItIsDrawn) {
  EXPECT_EQ(text_width("", 1), 0);
  EXPECT_EQ(text_width("m", 1), 5);
  EXPECT_EQ(text_width("mm", 3), 33);
  EXPECT_EQ(text_width("\xC3\xA4", 1), 5);  // One UTF-8 character.
}

TEST(BitmapText, StaysInThePicture) {
  sim::Image image = black(4, 4);
  draw_text(image, {-3, -3}, "HHH\n\xF0\x9F\xA4\x96", 3, 0xFFFFFF);
  fill_box(image, {2, 2}, {100, 100}, 0xFFFFFF);
  EXPECT_EQ(image.pixels.size(), 48U);
  EXPECT_EQ(image.pixels.back(), 255);
}

}  // namespace
}  // namespace castaway::testbed
