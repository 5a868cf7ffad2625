#include "tools/base/formats/volume/octomap_file.hpp"

#include <stdexcept>

#include <gtest/gtest.h>
#include <boost/random/uniform_int_distribution.hpp>

#include "localization/geometry/random.hpp"
#include "localization/space/map3d/voxel_builder.hpp"

namespace castaway::testbed {
namespace {

using localization::Rng;
using localization::VoxelBuilder;
using localization::VoxelMap;

/// Scattered voxels, and a block of 4 x 4 x 4, which a tree prunes to one leaf.
VoxelMap some_voxels() {
  VoxelBuilder builder(0.25);
  Rng rng(3);
  boost::random::uniform_int_distribution<int> draw(-60, 60);
  for (int i = 0; i < 200; ++i) {
    const Eigen::Vector3d index(draw(rng), draw(rng), draw(rng));
    builder.add((index.array() + 0.5) * 0.25);
  }
  for (int i = 0; i < 64; ++i) {
    const Eigen::Vector3d index(100 + i % 4, 100 + i / 4 % 4, 100 + i / 16);
    builder.add((index.array() + 0.5) * 0.25);
  }
  return builder.build();
}

TEST(OctomapFile, BothKindsGiveTheVoxelsBack) {
  const VoxelMap map = some_voxels();
  for (const OctomapKind kind : {OctomapKind::kBinary, OctomapKind::kFull}) {
    const std::string bytes = encode_octomap(map, kind);
    EXPECT_EQ(octomap_kind(bytes, "x"), kind);
    const VoxelMap read = decode_octomap(bytes, "x");
    EXPECT_EQ(read.resolution, map.resolution);
    EXPECT_EQ(read.keys, map.keys);
    EXPECT_LT((read.point(5) - map.point(5)).norm(), 0.002);
    EXPECT_EQ(encode_octomap(map, kind), bytes);
  }
}

TEST(OctomapFile, AnEmptyTreeIsAnEmptyMap) {
  const VoxelMap empty{0.1, {}, {}, {}};
  for (const OctomapKind kind : {OctomapKind::kBinary, OctomapKind::kFull}) {
    EXPECT_EQ(decode_octomap(encode_octomap(empty, kind), "x").size(), 0U);
  }
}

TEST(OctomapFile, VoxelsTooFarAwayAreRefused) {
  VoxelBuilder builder(0.1);
  builder.add({4000.0, 0.0, 0.0});
  EXPECT_THROW(encode_octomap(builder.build(), OctomapKind::kBinary), std::invalid_argument);
}

std::string octomap_refusal(const std::string& bytes) {
  try {
    (void)decode_octomap(bytes, "cave.bt");
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "read";
}

TEST(OctomapFile, WhatIsNoneIsNamed) {
  EXPECT_EQ(octomap_refusal("#!/bin/sh\n"),
            "cave.bt: is no OctoMap file: it does not begin with '# Octomap OcTree'");
  EXPECT_EQ(octomap_refusal("# Octomap OcTree binary file\nid OcTree\n"),
            "cave.bt: has no line 'data' in its first 4 kB");
  EXPECT_EQ(octomap_refusal("# Octomap OcTree file\nid ColorOcTree\nsize 1\nres 0.1\ndata\n"),
            "cave.bt: holds no tree of occupancies; convert it to one (id OcTree)");
  EXPECT_EQ(octomap_refusal("# Octomap OcTree file\nid OcTree\nsize 1\nres nan\ndata\n"),
            "cave.bt: its line 'res' states no edge of 1 mm to 100 m");
  EXPECT_EQ(octomap_refusal("# Octomap OcTree file\nid OcTree\nsize many\nres 0.1\ndata\n"),
            "cave.bt: its line 'size' states no number of nodes");
}

TEST(OctomapFile, ATreeWithoutEndIsRefused) {
  const std::string head = "# Octomap OcTree binary file\nid OcTree\nsize 9\nres 0.1\ndata\n";
  EXPECT_EQ(octomap_refusal(head + std::string(1 << 20, '\xff')),
            "cave.bt: the tree is deeper than 16 levels; the file is damaged");
  EXPECT_EQ(octomap_refusal(head + "\xff"), "cave.bt: the tree is cut off; copy the file again");
}

/// 256 x 256 x 256 voxels in a leaf of 16 bytes: they would take 0.8 GB.
TEST(OctomapFile, ALargeCubeIsRefusedBeforeItTakesMemory) {
  std::string nodes;
  for (int depth = 0; depth < 7; ++depth) nodes += std::string("\x03\0", 2);
  nodes += std::string("\x06\0", 2);  // One leaf is occupied, one is free.
  const std::string head = "# Octomap OcTree binary file\nid OcTree\nsize 10\nres 0.1\ndata\n";
  EXPECT_EQ(octomap_refusal(head + nodes),
            "cave.bt: has more than 10 million occupied voxels; use larger voxels");
}

TEST(OctomapFile, DamageIsNoCrash) {
  Rng rng(11);
  for (const OctomapKind kind : {OctomapKind::kBinary, OctomapKind::kFull}) {
    const std::string whole = encode_octomap(some_voxels(), kind);
    boost::random::uniform_int_distribution<std::size_t> at(0, whole.size() - 1);
    for (int i = 0; i < 100; ++i) {
      std::string bytes = whole.substr(0, i % 3 == 0 ? at(rng) : whole.size());
      if (i % 3 != 0) bytes[at(rng)] = static_cast<char>(rng());
      try {
        const VoxelMap read = decode_octomap(bytes, "x");
        EXPECT_NO_THROW(validate(read));
      } catch (const std::runtime_error& error) {
        EXPECT_EQ(std::string(error.what()).rfind("x: ", 0), 0U) << error.what();
      }
    }
  }
}

}  // namespace
}  // namespace castaway::testbed
