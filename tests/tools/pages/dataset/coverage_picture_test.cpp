#include "tools/pages/dataset/dataset_pages.hpp"

#include <gtest/gtest.h>
#include <png.h>

namespace castaway::testbed {
namespace {

/// RGB, row 0 at the top.
std::vector<std::uint8_t> pixels_of(const std::string& bytes, int width, int height) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  EXPECT_NE(png_image_begin_read_from_memory(&image, bytes.data(), bytes.size()), 0);
  EXPECT_EQ(static_cast<int>(image.width), width);
  EXPECT_EQ(static_cast<int>(image.height), height);
  image.format = PNG_FORMAT_RGB;
  std::vector<std::uint8_t> pixels(PNG_IMAGE_SIZE(image));
  png_image_finish_read(&image, nullptr, pixels.data(), 0, nullptr);
  return pixels;
}

TEST(CoveragePicture, PutsHeatOverTheMap) {
  RosMap map;
  map.width = 2;
  map.height = 2;
  map.resolution = 0.5;
  map.origin_x = -0.5;
  map.cells = {0, 100, 0, -1};  // Bottom: free, wall; top: free, unknown.
  const auto pixels = pixels_of(coverage_png(map, {{{-1, 0}, 7.0}}, 0.5), 2, 2);
  const auto at = [&](std::size_t row, std::size_t column) {
    const std::size_t i = 3 * (2 * row + column);
    return std::vector<int>{pixels[i], pixels[i + 1], pixels[i + 2]};
  };
  EXPECT_EQ(at(0, 0), (std::vector<int>{255, 255, 255}));
  EXPECT_EQ(at(0, 1), (std::vector<int>{204, 204, 204}));
  EXPECT_EQ(at(1, 0), (std::vector<int>{153, 0, 25}));  // Most scans: dark red.
  EXPECT_EQ(at(1, 1), (std::vector<int>{0, 0, 0}));
}

}  // namespace
}  // namespace castaway::testbed
