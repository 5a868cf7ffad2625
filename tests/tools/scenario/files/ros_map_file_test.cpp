#include "tools/scenario/files/ros_map_file.hpp"

#include <gtest/gtest.h>

#include "tests/tools/support/real_data.hpp"
#include "tests/tools/support/temporary.hpp"

namespace castaway::testbed {
namespace {

TEST(RosMapFile, FindsThePictureBesideIt) {
  const TemporaryFolder folder;
  folder.put("office/pictures/a.pgm", "P5 2 1 255\n\x01\xfe");
  const auto path = folder.put("office/map.yaml",
                               "image: pictures/a.pgm\nresolution: 0.1\norigin: [1, -2, 0.5]\n"
                               "negate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n");
  const RosMap map = load_ros_map(path);
  EXPECT_EQ(map.name, "office");
  EXPECT_EQ(map.resolution, 0.1);
  EXPECT_EQ(map.origin_x, 1.0);
  EXPECT_EQ(map.origin_y, -2.0);
  EXPECT_EQ(map.origin_yaw, 0.5);
  EXPECT_EQ(map.cells, (std::vector<std::int8_t>{100, 0}));
}

TEST(RosMapFile, ReadsModeAndNegate) {
  const TemporaryFolder folder;
  folder.put("a.pgm", "P5 2 1 255\n\x32\xfe");
  const auto path = folder.put(
      "a.yaml", "image: a.pgm\nresolution: 0.1\norigin: [0, 0, 0]\nnegate: 1\nmode: raw\n");
  EXPECT_EQ(load_ros_map(path).cells, (std::vector<std::int8_t>{50, -1}));
  EXPECT_EQ(load_ros_map(path).name, "a");
}

/// As in nav2's map_server.
TEST(RosMapFile, ReadsModesInAnyLetterCase) {
  const TemporaryFolder folder;
  folder.put("a.pgm", "P5 2 1 255\n\x32\x80");
  const auto cells = [&](const std::string& mode) {
    return load_ros_map(folder.put("a.yaml", "image: a.pgm\nresolution: 0.1\norigin: [0, 0, 0]\n" +
                                                 (mode.empty() ? "" : "mode: " + mode + "\n")))
        .cells;
  };
  for (const char* mode : {"", "trinary", "Trinary", "TRINARY", "\"Trinary\""}) {
    EXPECT_EQ(cells(mode), (std::vector<std::int8_t>{100, -1})) << mode;
  }
  for (const char* mode : {"scale", "Scale", "SCALE"}) {
    EXPECT_EQ(cells(mode), (std::vector<std::int8_t>{100, 67})) << mode;
  }
  for (const char* mode : {"raw", "Raw", "RAW"}) {
    EXPECT_EQ(cells(mode), (std::vector<std::int8_t>{50, -1})) << mode;
  }
}

TEST(RosMapFile, NamesTheModeThatIsMeant) {
  const TemporaryFolder folder;
  folder.put("a.pgm", "P5 2 1 255\n\x32\x80");
  const auto error = [&](const std::string& mode) {
    return error_of([&] {
      load_ros_map(folder.put(
          "m.yaml", "image: a.pgm\nresolution: 0.1\norigin: [0, 0, 0]\nmode: " + mode + "\n"));
    });
  };
  EXPECT_TRUE(contains(error("TRINRY"),
                       "m.yaml:4: mode: 'TRINRY' is not allowed here; did you mean 'trinary'"));
  EXPECT_TRUE(contains(error("Scaled"), "did you mean 'scale'"));
  EXPECT_TRUE(contains(error("RWA"), "'raw'"));
  EXPECT_TRUE(contains(error("binary"), "trinary"));
}

TEST(RosMapFile, NamesFileKeyAndRemedy) {
  const TemporaryFolder folder;
  folder.put("a.pgm", "P5 9 9 255\n");
  const auto error = [&](const std::string& text) {
    return error_of([&] { load_ros_map(folder.put("m.yaml", text)); });
  };
  const std::string head = "image: a.pgm\nresolution: 0.1\norigin: [0, 0, 0]\n";
  EXPECT_TRUE(contains(error(head), "a.pgm: cut short"));
  EXPECT_TRUE(contains(error("image: b.pgm\nresolution: 0.1\norigin: [0, 0, 0]\n"),
                       "b.pgm: cannot be read"));
  EXPECT_TRUE(
      contains(error("image: a.pgm\norigin: [0, 0, 0]\n"), "m.yaml:1: needs the key 'resolution'"));
  EXPECT_TRUE(contains(error(head + "mode: trinry\n"), "m.yaml:4: mode: 'trinry'"));
  EXPECT_TRUE(contains(error(head + "negate: 3\n"), "m.yaml:4: negate"));
  EXPECT_TRUE(contains(error(head + "free_thresh: 0.9\n"), "free_thresh must be below"));
  EXPECT_TRUE(
      contains(error("image: a.pgm\nresolution: 0\norigin: [0, 0, 0]\n"), "m.yaml:2: resolution"));
}

TEST(RosMapFile, ReadsTheMapsOfRealRobots) {
  const auto data = real_data();
  if (!data) GTEST_SKIP() << kNoRealData;
  const RosMap map = load_ros_map(*data / "intel/map.yaml");
  EXPECT_EQ(map.name, "intel");
  EXPECT_EQ(map.width, 627);
  EXPECT_EQ(map.height, 761);
  EXPECT_EQ(std::count(map.cells.begin(), map.cells.end(), 100), 15439);  // stats.json
  EXPECT_EQ(std::count(map.cells.begin(), map.cells.end(), 0), 192699);
}

}  // namespace
}  // namespace castaway::testbed
