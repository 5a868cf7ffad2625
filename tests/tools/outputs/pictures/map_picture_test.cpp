#include "tools/outputs/pictures/map_picture.hpp"

#include <gtest/gtest.h>

#include "tests/tools/support/records.hpp"

namespace castaway::testbed {
namespace {

constexpr int kPictureWidth = 480;
constexpr int kPictureHeight = 320;

PictureWorld map_of(int width, int height) {
  PictureWorld world;
  world.map.emplace();
  world.map->width = width;
  world.map->height = height;
  world.map->resolution = 0.1;
  world.map->cells.assign(static_cast<std::size_t>(width * height), 0);
  return world;
}

bool is_white(const sim::Image& image, int x, int y) {
  const auto first = static_cast<std::size_t>(3 * (y * image.width + x));
  return image.pixels[first] == 255 && image.pixels[first + 1] == 255;
}

TEST(MapCaptionOfARecord, NamesTruthAndLocalizers) {
  const MapCaption caption = caption_of(record_at(12.34, {"mh_amcl", "amcl"}));
  EXPECT_EQ(caption.clock, "12.3 s");
  ASSERT_EQ(caption.entries.size(), 3U);
  EXPECT_EQ(caption.entries[0].name, "truth");
  EXPECT_EQ(caption.entries[2].name, "amcl");
  ScanRecord among_people = record_at(1.0, {"amcl"});
  among_people.people.people.emplace_back();
  EXPECT_EQ(caption_of(among_people).entries.back().name, "people");
  ScanRecord recorded = record_at(1.0, {"amcl"});
  recorded.true_pose.reset();
  EXPECT_EQ(caption_of(recorded).entries.size(), 1U);
}

TEST(MapView, LeavesTheCaptionItsShare) {
  const RosMap map = *map_of(100, 100).map;  // 10 x 10 m.
  EXPECT_NEAR(map_height(map, {1.5, 0.0}), 10.2, 1e-9);
  EXPECT_NEAR(map_height(map, {1.5, 0.2}), 12.75, 1e-9);
  EXPECT_NEAR(map_height(map, {0.5, 0.2}), 20.4, 1e-9);
}

/// The whole map is visible above the caption.
TEST(MapPicture, HidesNothingOfTheMap) {
  try {
    sim::Renderer renderer(kPictureWidth, kPictureHeight);
    for (const auto& [width, height] : {std::pair{100, 100}, {200, 60}, {40, 200}}) {
      const PictureWorld world = map_of(width, height);
      ScanRecord record = record_at(1.0, {"a", "b"});
      const int strip = caption_height(caption_of(record), kPictureWidth, kPictureHeight);
      record.true_pose = SE2{-90.0, 0.0, 0.0};  // Outside the image.
      for (auto& localizer : record.localizers) localizer.estimate.reset();
      const sim::Image image = map_picture(renderer, world, map_item(*world.map), record);
      const double scale =
          kPictureHeight / map_height(*world.map, {1.5, double(strip) / kPictureHeight});
      int white = 0;
      for (int y = 0; y < kPictureHeight - strip; ++y) {
        for (int x = 0; x < kPictureWidth; ++x) white += is_white(image, x, y) ? 1 : 0;
      }
      const double expected = width * height * 0.01 * scale * scale;
      EXPECT_NEAR(white, expected, 0.04 * expected) << width;  // The rim is half covered.
    }
  } catch (const std::runtime_error& error) {
    GTEST_SKIP() << error.what();
  }
}

}  // namespace
}  // namespace castaway::testbed
