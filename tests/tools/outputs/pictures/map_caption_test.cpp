#include "tools/outputs/pictures/map_caption.hpp"

#include <gtest/gtest.h>

#include "tools/outputs/pictures/palette.hpp"

namespace castaway::testbed {
namespace {

constexpr int kWidth = 960;
constexpr int kHeight = 640;
constexpr std::uint32_t kMap = 0x123456;

MapCaption caption(int localizers) {
  MapCaption caption{"12.3 s", {{"truth", 0x000000, true}}, 60.0};
  for (int i = 0; i < localizers; ++i) {
    caption.entries.push_back({"localizer-" + std::to_string(i),
                               palette_color(kLocalizerColors, static_cast<std::size_t>(i)),
                               false});
  }
  return caption;
}

sim::Image with_caption(const MapCaption& caption, int width = kWidth, int height = kHeight) {
  sim::Image image{width, height, {}};
  for (int i = 0; i < width * height; ++i) image.pixels.insert(image.pixels.end(), {18, 52, 86});
  draw_caption(caption, image);
  return image;
}

std::uint32_t at(const sim::Image& image, int x, int y) {
  const auto first = static_cast<std::size_t>(3 * (y * image.width + x));
  return std::uint32_t{image.pixels[first]} << 16U | std::uint32_t{image.pixels[first + 1]} << 8U |
         image.pixels[first + 2];
}

int count(const sim::Image& image, std::uint32_t rgb) {
  int found = 0;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) found += at(image, x, y) == rgb ? 1 : 0;
  }
  return found;
}

TEST(RoundLength, IsOneTwoOrFive) {
  EXPECT_DOUBLE_EQ(round_length(1.0), 1.0);
  EXPECT_DOUBLE_EQ(round_length(1.99), 1.0);
  EXPECT_DOUBLE_EQ(round_length(4.9), 2.0);
  EXPECT_DOUBLE_EQ(round_length(7.0), 5.0);
  EXPECT_DOUBLE_EQ(round_length(0.3), 0.2);
  EXPECT_DOUBLE_EQ(round_length(120.0), 100.0);
}

TEST(MapCaption, CoversItsStripAlone) {
  const MapCaption two = caption(2);
  const int strip = caption_height(two, kWidth, kHeight);
  EXPECT_LT(strip, kHeight / 10);
  const sim::Image image = with_caption(two);
  EXPECT_EQ(count(image, kMap), kWidth * (kHeight - strip));
  EXPECT_EQ(at(image, 0, kHeight - strip - 1), kMap);
  EXPECT_NE(at(image, 0, kHeight - strip), kMap);
}

TEST(MapCaption, ShowsEveryColour) {
  const sim::Image image = with_caption(caption(6));
  for (const std::uint32_t rgb : kLocalizerColors) EXPECT_GT(count(image, rgb), 100) << rgb;
  EXPECT_GT(count(image, 0x000000), 50);
}

/// The longest black run is the bar: 3 m at 60 px/m would be 180 px, 2 m are 120 px.
TEST(MapCaption, DrawsARoundNumberOfMetres) {
  const sim::Image image = with_caption(caption(0));
  int longest = 0;
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0, run = 0; x < kWidth; ++x) {
      run = at(image, x, y) == 0x1D2328 ? run + 1 : 0;
      longest = std::max(longest, run);
    }
  }
  EXPECT_EQ(longest, 120);
}

TEST(MapCaption, BreaksLines) {
  const int one = caption_height(caption(1), kWidth, kHeight);
  EXPECT_GT(caption_height(caption(9), kWidth, kHeight), one);
  EXPECT_LE(caption_height(caption(200), kWidth, kHeight), kHeight / 3);
  EXPECT_NO_THROW(with_caption(caption(200)));
}

TEST(MapCaption, FitsTinyPictures) {
  for (const int side : {1, 16, 48, 100}) {
    EXPECT_LE(caption_height(caption(3), side, side), side / 3);
    EXPECT_NO_THROW(with_caption(caption(3), side, side));
  }
}

}  // namespace
}  // namespace castaway::testbed
