#include "tools/base/formats/ros_map.hpp"

#include <numbers>

#include <gtest/gtest.h>

#include "tests/tools/support/temporary.hpp"
#include "tools/base/files/file.hpp"

namespace castaway::testbed {
namespace {

using Cells = std::vector<std::int8_t>;

Cells cells_of(const std::vector<std::uint16_t>& pixels, const RosMapHeader& header,
               int max_value = 255) {
  return make_ros_map({static_cast<int>(pixels.size()), 1, max_value, pixels}, header, "m").cells;
}

TEST(RosMap, TurnsTheTopRowIntoTheLargestY) {
  const RosMap map = make_ros_map({2, 2, 255, {0, 254, 205, 254}}, {}, "m");
  EXPECT_EQ(map.cells, (Cells{-1, 0, 100, 0}));
  EXPECT_EQ(map.at(0, 1), 100);
}

TEST(RosMap, KnowsThreeValuesByItsThresholds) {
  // p = (255 - grey) / 255: 89 is 0.651, 90 is 0.647, 205 is 0.19608, 206 is 0.192.
  EXPECT_EQ(cells_of({0, 89, 90, 205, 206, 255}, {}), (Cells{100, 100, -1, -1, 0, 0}));
}

TEST(RosMap, TakesUnknownForFreeWhereTheThresholdSaysSo) {
  RosMapHeader header;
  header.free_thresh = 0.25;
  EXPECT_EQ(cells_of({205}, header), (Cells{0}));
}

/// An image of ten cells, two of which are grey 205.
GrayImage partly_unknown() {
  return {10, 1, 255, {205, 205, 0, 254, 254, 254, 254, 254, 254, 254}};
}

TEST(RosMap, WarnsWhereTheUnknownIsFree) {
  RosMapHeader header;
  EXPECT_TRUE(make_ros_map(partly_unknown(), header, "m").warnings.empty());
  header.free_thresh = 0.25;
  const RosMap map = make_ros_map(partly_unknown(), header, "m");
  ASSERT_EQ(map.warnings.size(), 1U);
  EXPECT_TRUE(contains(map.warnings.front(), "free_thresh 0.25 makes grey 205"));
  EXPECT_TRUE(contains(map.warnings.front(), "20 %"));
  const GrayImage without{2, 1, 255, {0, 254}};
  EXPECT_TRUE(make_ros_map(without, header, "m").warnings.empty());
}

TEST(RosMap, TakesTransparentPixelsForUnknown) {
  GrayImage image{2, 2, 255, {254, 254, 0, 254}};
  image.transparent = {true, false, true, false};
  RosMapHeader header;
  for (const MapMode mode : {MapMode::kTrinary, MapMode::kScale}) {
    header.mode = mode;
    const RosMap map = make_ros_map(image, header, "m");
    EXPECT_EQ(map.cells, (Cells{-1, 0, -1, 0}));
    ASSERT_EQ(map.warnings.size(), 1U);
    EXPECT_TRUE(contains(map.warnings.front(), "50.0 % of its picture is transparent"));
  }
  header.mode = MapMode::kRaw;
  EXPECT_EQ(make_ros_map(image, header, "m").cells, (Cells{0, -1, -1, -1}));
}

TEST(RosMap, Negates) {
  RosMapHeader header;
  header.negate = true;
  EXPECT_EQ(cells_of({0, 255, 128}, header), (Cells{0, 100, -1}));
}

TEST(RosMap, ScalesBetweenTheThresholds) {
  RosMapHeader header;
  header.mode = MapMode::kScale;
  header.free_thresh = 0.0;
  header.occupied_thresh = 1.0;
  EXPECT_EQ(cells_of({0, 51, 255, 100}, header), (Cells{100, 80, 0, 61}));
}

TEST(RosMap, TakesRawValues) {
  RosMapHeader header;
  header.mode = MapMode::kRaw;
  header.negate = true;
  EXPECT_EQ(cells_of({0, 55, 100, 101, 255}, header), (Cells{0, 55, 100, -1, -1}));
}

TEST(RosMap, DoesNotCareAboutTheLargestValue) {
  EXPECT_EQ(cells_of({0, 5, 10}, {}, 10), (Cells{100, -1, 0}));
  EXPECT_EQ(cells_of({0, 65535}, {}, 65535), (Cells{100, 0}));
}

TEST(RosMap, ShowsWhatIsKnown) {
  RosMap map{"m", 100, 60, 0.5, -3.0, 2.0, 0.0, std::vector<std::int8_t>(6000, -1)};
  map.cells[20 * 100 + 40] = 0;
  map.cells[25 * 100 + 50] = 100;
  const RosMap part = known_part(map);
  EXPECT_EQ(part.width, 11 + 4);
  EXPECT_EQ(part.height, 6 + 4);
  EXPECT_EQ(part.at(2, 2), 0);
  EXPECT_EQ(part.at(12, 7), 100);
  EXPECT_TRUE(part.to_map({2.0, 2.0}).isApprox(map.to_map({40.0, 20.0})));
}

/// Turned by a right angle, the known part lies where it lay.
TEST(RosMap, ShowsWhatIsKnownOfATurnedMap) {
  RosMap map{"m", 100, 60, 0.5, 0.0, 0.0, 1.5707963267948966, std::vector<std::int8_t>(6000, -1)};
  map.cells[20 * 100 + 40] = 0;
  const RosMap part = known_part(map);
  EXPECT_TRUE(part.to_map({2.0, 2.0}).isApprox(Eigen::Vector2d(-10.0, 20.0)));
}

TEST(RosMap, ShowsAllWhereMostIsKnown) {
  RosMap map{"m", 10, 10, 0.5, 0.0, 0.0, 0.0, std::vector<std::int8_t>(100, -1)};
  map.cells[11] = map.cells[88] = 0;
  EXPECT_EQ(known_part(map).width, 10);
}

TEST(RosMap, TurnsAboutItsOrigin) {
  RosMap map;
  map.resolution = 0.5;
  map.origin_x = 1.0;
  map.origin_y = 2.0;
  map.origin_yaw = std::numbers::pi / 2.0;
  EXPECT_TRUE(map.to_map({4.0, 0.0}).isApprox(Eigen::Vector2d(1.0, 4.0), 1e-12));
}

TEST(RosMap, IsWrittenAsMapServerReadsIt) {
  const TemporaryFolder folder;
  RosMap map{"m", 3, 2, 0.05, -1.0, 2.5, 0.0, {100, 0, -1, 0, 0, 100}};
  write_ros_map(map, folder.path() / "map.yaml");
  EXPECT_EQ(read_file(folder.path() / "map.yaml"),
            "image: map.pgm\nmode: trinary\nresolution: 0.05\norigin: [-1.0, 2.5, 0.0]\nnegate: 0\n"
            "occupied_thresh: 0.65\nfree_thresh: 0.196\n");
  const GrayImage image = load_gray_image(folder.path() / "map.pgm");
  EXPECT_EQ(image.pixels, (std::vector<std::uint16_t>{254, 254, 0, 0, 254, 205}));
  EXPECT_EQ(make_ros_map(image, {}, "m").cells, map.cells);
}

}  // namespace
}  // namespace castaway::testbed
