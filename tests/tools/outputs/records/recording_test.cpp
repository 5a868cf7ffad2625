#include "tools/outputs/records/recording.hpp"

#include <gtest/gtest.h>

#include "tests/tools/support/recorded_map.hpp"
#include "tests/tools/support/temporary.hpp"
#include "tools/base/bytes/gzip.hpp"

namespace castaway::testbed {
namespace {

std::string packed() {
  return pack_recording({{"map", map_header(recorded_map())}},
                        {{"map", pack_cells(recorded_map())}, {"b", "bytes"}, {"none", ""}});
}

TEST(Recording, IsTakenApartAsItWasPutTogether) {
  const Recording recording = unpack_recording(packed());
  EXPECT_EQ(recording.sections.at("b"), "bytes");
  EXPECT_EQ(recording.sections.at("none"), "");
  EXPECT_EQ(recording.sections.at("map"), std::string("\x01\x02\x00\x02\x65\x01\x3d\x01", 8));
}

TEST(Recording, KeepsItsMap) {
  const RosMap map = map_of(unpack_recording(packed()));
  EXPECT_EQ(map.name, "small");
  EXPECT_EQ(map.width, 3);
  EXPECT_EQ(map.height, 2);
  EXPECT_EQ(map.resolution, 0.5);
  EXPECT_EQ(map.origin_x, -1.0);
  EXPECT_EQ(map.origin_y, 2.0);
  EXPECT_EQ(map.origin_yaw, 0.25);
  EXPECT_EQ(map.cells, recorded_map().cells);
}

TEST(Recording, IsTheSameForTheSame) { EXPECT_EQ(packed(), packed()); }

TEST(Recording, RefusesWhatIsNone) {
  const auto error = [](const std::string& bytes) {
    return error_of([&] { unpack_recording(gzip(bytes)); });
  };
  EXPECT_TRUE(contains(error("castaway recording 2\n{}\n"), "first line"));
  EXPECT_TRUE(contains(error("castaway recording 1\n{}"), "ends within its header"));
  EXPECT_TRUE(contains(error("castaway recording 1\n{\n"), "header is broken"));
  EXPECT_TRUE(contains(error("castaway recording 1\n{\"sections\": [{\"name\": \"a\", \"bytes\": "
                             "9}]}\n12345678"),
                       "section \"a\""));
  EXPECT_TRUE(contains(error_of([] { unpack_recording("text"); }), "not a gzip stream"));
}

TEST(Recording, RefusesAMapThatIsNotWhole) {
  RosMap map = recorded_map();
  const auto error = [&](const std::string& cells) {
    const std::string file = pack_recording({{"map", map_header(map)}}, {{"map", cells}});
    return error_of([&] { map_of(unpack_recording(file)); });
  };
  EXPECT_TRUE(contains(error(std::string("\x01\x05", 2)), "lacks cells"));
  EXPECT_TRUE(contains(error(std::string("\x01\x07", 2)), "too many cells"));
}

LevelMaps two_levels() {
  RosMap upper = recorded_map();
  upper.cells.assign(upper.cells.size(), 0);
  return {{0.0, recorded_map()}, {3.5, upper}};
}

TEST(Recording, KeepsTheMapsOfFloors) {
  const LevelMaps levels = two_levels();
  const Recording recording = unpack_recording(pack_recording(
      {{"levels", levels_header(levels)}},
      {{"level/0", pack_cells(levels[0].map)}, {"level/1", pack_cells(levels[1].map)}}));
  const LevelMaps read = levels_of(recording);
  ASSERT_EQ(read.size(), 2U);
  EXPECT_EQ(read[1].z, 3.5);
  EXPECT_EQ(read[1].map.origin_y, 2.0);
  EXPECT_EQ(read[0].map.cells, levels[0].map.cells);
  EXPECT_EQ(read[1].map.cells, levels[1].map.cells);
}

TEST(Recording, HasNoFloorsOfAPlanarRun) {
  EXPECT_TRUE(levels_of(unpack_recording(packed())).empty());
}

TEST(Recording, RefusesAFloorThatIsMissing) {
  const LevelMaps levels = two_levels();
  const std::string file =
      pack_recording({{"levels", levels_header(levels)}}, {{"level/0", pack_cells(levels[0].map)}});
  EXPECT_TRUE(contains(error_of([&] { levels_of(unpack_recording(file)); }), "level/1"));
}

}  // namespace
}  // namespace castaway::testbed
