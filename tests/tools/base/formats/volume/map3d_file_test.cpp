#include "tools/base/formats/volume/map3d_file.hpp"

#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>

#include "localization/space/map3d/voxel_builder.hpp"
#include "tools/base/bytes/compression.hpp"

namespace castaway::testbed {
namespace {

Map3d small_map() {
  localization::VoxelBuilder builder(0.1);
  for (int i = 0; i < 40; ++i) builder.add({0.07 * i, -0.05 * i, 0.01 * i}, i % 3 == 0);
  Map3d map;
  map.voxels = builder.build();
  map.ground.frame = {2, 2, 0.1, {-1.0, 0.5, 0.25}};
  map.ground.first = {0, 2, 2, 3, 3};
  map.ground.surfaces = {{0.5F, 0.01F, -0.02F, 2.5F, 0, true},
                         {3.0F, 0.0F, 0.0F, std::numeric_limits<float>::infinity(), 1, false},
                         {0.75F, 0.1F, 0.0F, 1.5F, 0, true}};
  map.ground.levels = {0.5F, 3.0F};
  return map;
}

TEST(Map3dFile, GivesTheMapBack) {
  const Map3d map = small_map();
  const std::string bytes = encode_map3d(map);
  EXPECT_TRUE(bytes.starts_with(kMap3dHead));
  const Map3d read = decode_map3d(bytes, "x");
  EXPECT_EQ(read.voxels.resolution, map.voxels.resolution);
  EXPECT_EQ(read.voxels.keys, map.voxels.keys);
  EXPECT_EQ(read.voxels.offsets, map.voxels.offsets);
  EXPECT_EQ(read.voxels.faces_up, map.voxels.faces_up);
  EXPECT_EQ(read.ground.frame.T_map_grid, map.ground.frame.T_map_grid);
  EXPECT_EQ(read.ground.first, map.ground.first);
  EXPECT_EQ(read.ground.levels, map.ground.levels);
  EXPECT_EQ(read.ground.surfaces[1].clearance, map.ground.surfaces[1].clearance);
  EXPECT_EQ(encode_map3d(read), bytes);
}

std::string map3d_refusal(const std::string& bytes) {
  try {
    (void)decode_map3d(bytes, "a.map3d");
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "read";
}

// A few kilobytes of zstd hold a map that takes gigabytes to prepare.
TEST(Map3dFile, AMapTooLargeToPrepareIsRefusedBeforeItTakesMemory) {
  const auto number = [](auto value) {
    return std::string(reinterpret_cast<const char*>(&value), sizeof(value));
  };
  const auto packed = [](const std::string& inner) {
    return std::string(kMap3dHead) + pack_chunk(inner, Compression::kZstd);
  };
  const std::uint64_t voxels = 10'000'001;
  const std::string many = number(0.1) + number(voxels) + number(voxels);
  EXPECT_EQ(map3d_refusal(packed(many)),
            "a.map3d: has more than 10 million voxels; use larger voxels, or a part of the map");
  const std::string none = number(0.1) + number(std::uint64_t{0}) + number(std::uint64_t{0});
  const std::string frame = number(0.1) + number(0.0) + number(0.0) + number(0.0);
  const std::string wide = none + number(std::uint32_t{5001}) + number(std::uint32_t{5000}) + frame;
  EXPECT_EQ(map3d_refusal(packed(wide)),
            "a.map3d: its ground has more than 25 million cells; use larger voxels, or a part of "
            "the map");
  const std::string deep = none + number(std::uint32_t{1000}) + number(std::uint32_t{100}) + frame;
  EXPECT_EQ(
      map3d_refusal(packed(deep + std::string(100'000, 101))),
      "a.map3d: its ground has more than 10 million surfaces; use larger voxels, or a part of "
      "the map");
}

TEST(Map3dFile, WhatIsNoneIsNamed) {
  EXPECT_EQ(map3d_refusal("castaway"),
            "a.map3d: is no 3-D map of this castaway: it does not begin with 'castaway-map3d 1'");
  EXPECT_EQ(map3d_refusal(std::string(kMap3dHead) + "no frame"),
            "a.map3d: its zstd frame is damaged (Unknown frame descriptor)");
  EXPECT_EQ(map3d_refusal(std::string(kMap3dHead) + pack_chunk("", Compression::kZstd)),
            "a.map3d: ends too early");
}

TEST(Map3dFile, DamageIsNamedAndNoCrash) {
  const std::string whole = encode_map3d(small_map());
  for (std::size_t size = 0; size < whole.size(); ++size) {
    EXPECT_EQ(map3d_refusal(whole.substr(0, size)).rfind("a.map3d: ", 0), 0U) << size;
  }
  const std::string inner =
      unpack_chunk(std::string_view(whole).substr(kMap3dHead.size()), "zstd", 1 << 20).bytes;
  for (std::size_t at = 0; at < inner.size(); ++at) {
    for (const char flip : {'\x01', '\x80', '\xff'}) {
      std::string bytes = inner;
      bytes[at] = static_cast<char>(bytes[at] ^ flip);
      const std::string answer =
          map3d_refusal(std::string(kMap3dHead) + pack_chunk(bytes, Compression::kZstd));
      EXPECT_TRUE(answer == "read" || answer.rfind("a.map3d: ", 0) == 0) << at << ' ' << answer;
    }
  }
}

}  // namespace
}  // namespace castaway::testbed
