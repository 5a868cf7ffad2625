#include "tools/base/formats/volume/map3d_file.hpp"

#include <stdexcept>
#include <vector>

#include "tools/base/bytes/byte_reader.hpp"
#include "tools/base/bytes/byte_writer.hpp"
#include "tools/base/bytes/compression.hpp"
#include "tools/base/bytes/varint.hpp"

namespace castaway::testbed {
namespace {

using localization::ElevationMap;
using localization::GroundSurface;
using localization::VoxelMap;

constexpr std::size_t kMostPerCell = 255;
constexpr std::uint64_t kMost = std::uint64_t{512} << 20U;  // [bytes] Unpacked.
constexpr std::uint64_t kMostVoxels = 10'000'000;           // A localizer takes 140 bytes for each.
constexpr std::uint64_t kMostSurfaces = 10'000'000;         // Of the ground.
constexpr std::uint64_t kMostCells = 25'000'000;  // Of the ground: 500 m x 500 m at 0.1 m.

/// Throws std::runtime_error if a map of this size would take more than 2 GiB or 20 s to prepare.
void require_size(std::uint64_t voxels, std::uint64_t cells, std::uint64_t surfaces) {
  const auto refuse = [](const std::string& what) {
    throw std::runtime_error(what + "; use larger voxels, or a part of the map");
  };
  if (voxels > kMostVoxels) refuse("has more than 10 million voxels");
  if (cells > kMostCells) refuse("its ground has more than 25 million cells");
  if (surfaces > kMostSurfaces) refuse("its ground has more than 10 million surfaces");
}

void put_voxels(std::string& bytes, const VoxelMap& map) {
  std::string keys;
  localization::VoxelKey last = 0;
  for (const localization::VoxelKey key : map.keys) {
    append_varint(keys, key - last);
    last = key;
  }
  append_number(bytes, map.resolution);
  append_number(bytes, static_cast<std::uint64_t>(map.size()));
  append_number(bytes, static_cast<std::uint64_t>(keys.size()));
  bytes.append(keys);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (const auto& offset : map.offsets) append_number(bytes, offset[axis]);
  }
  for (const std::uint8_t up : map.faces_up) append_number(bytes, up);
}

VoxelMap take_voxels(ByteReader& reader) {
  VoxelMap map;
  map.resolution = reader.number<double>();
  const auto count = reader.number<std::uint64_t>();
  require_size(count, 0, 0);
  if (count > reader.rest() / 5) {  // A key takes a byte at least, its point and flag four.
    throw std::runtime_error("states more voxels than it holds");
  }
  map.keys.reserve(count);
  VarintReader keys(reader.take(reader.number<std::uint64_t>()));
  localization::VoxelKey last = 0;
  for (std::size_t i = 0; i < count; ++i) map.keys.push_back(last += keys.next());
  map.offsets.resize(count);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (auto& offset : map.offsets) offset[axis] = reader.number<std::uint8_t>();
  }
  map.faces_up.resize(count);
  for (std::uint8_t& up : map.faces_up) up = reader.number<std::uint8_t>();
  validate(map);
  return map;
}

void put_ground(std::string& bytes, const ElevationMap& map) {
  append_number(bytes, static_cast<std::uint32_t>(map.frame.width));
  append_number(bytes, static_cast<std::uint32_t>(map.frame.height));
  for (const double value : {map.frame.resolution, map.frame.T_map_grid.x, map.frame.T_map_grid.y,
                             map.frame.T_map_grid.yaw}) {
    append_number(bytes, value);
  }
  for (std::size_t i = 0; i + 1 < map.first.size(); ++i) {
    const std::uint32_t count = map.first[i + 1] - map.first[i];
    if (count > kMostPerCell) throw std::invalid_argument("a cell has more than 255 surfaces");
    append_number(bytes, static_cast<std::uint8_t>(count));
  }
  for (const GroundSurface& s : map.surfaces) append_number(bytes, s.z);
  for (const GroundSurface& s : map.surfaces) append_number(bytes, s.slope_x);
  for (const GroundSurface& s : map.surfaces) append_number(bytes, s.slope_y);
  for (const GroundSurface& s : map.surfaces) append_number(bytes, s.clearance);
  for (const GroundSurface& s : map.surfaces) append_number(bytes, s.level);
  for (const GroundSurface& s : map.surfaces)
    append_number(bytes, static_cast<std::uint8_t>(s.drivable));
  append_number(bytes, static_cast<std::uint8_t>(map.levels.size()));
  for (const float level : map.levels) append_number(bytes, level);
}

localization::GridFrame take_frame(ByteReader& reader) {
  localization::GridFrame frame;
  const auto width = reader.number<std::uint32_t>();
  const auto height = reader.number<std::uint32_t>();
  require_size(0, std::uint64_t{width} * height, 0);
  if (std::uint64_t{width} * height > reader.rest()) {
    throw std::runtime_error("states more cells than it holds");
  }
  frame.width = static_cast<int>(width);
  frame.height = static_cast<int>(height);
  for (double* value :
       {&frame.resolution, &frame.T_map_grid.x, &frame.T_map_grid.y, &frame.T_map_grid.yaw}) {
    *value = reader.number<double>();
  }
  return frame;
}

ElevationMap take_ground(ByteReader& reader) {
  ElevationMap map;
  map.frame = take_frame(reader);
  map.first.reserve(map.frame.size() + 1);
  map.first.assign(1, 0);
  for (std::size_t i = 0; i < map.frame.size(); ++i) {
    map.first.push_back(map.first.back() + reader.number<std::uint8_t>());
  }
  require_size(0, 0, map.first.back());
  if (std::uint64_t{18} * map.first.back() > reader.rest()) {
    throw std::runtime_error("states more surfaces than it holds");
  }
  map.surfaces.resize(map.first.back());
  for (GroundSurface& s : map.surfaces) s.z = reader.number<float>();
  for (GroundSurface& s : map.surfaces) s.slope_x = reader.number<float>();
  for (GroundSurface& s : map.surfaces) s.slope_y = reader.number<float>();
  for (GroundSurface& s : map.surfaces) s.clearance = reader.number<float>();
  for (GroundSurface& s : map.surfaces) s.level = reader.number<std::uint8_t>();
  for (GroundSurface& s : map.surfaces) s.drivable = reader.number<std::uint8_t>() != 0;
  map.levels.resize(reader.number<std::uint8_t>());
  for (float& level : map.levels) level = reader.number<float>();
  validate(map);
  return map;
}

}  // namespace

std::string encode_map3d(const Map3d& map) {
  require_size(map.voxels.size(), map.ground.frame.size(), map.ground.surfaces.size());
  std::string inner;
  put_voxels(inner, map.voxels);
  put_ground(inner, map.ground);
  return std::string(kMap3dHead) + pack_chunk(inner, Compression::kZstd);
}

Map3d decode_map3d(std::string_view bytes, const std::string& name) {
  try {
    if (!bytes.starts_with(kMap3dHead)) {
      throw std::runtime_error("is no 3-D map of this castaway: it does not begin with '" +
                               std::string(kMap3dHead.substr(0, kMap3dHead.size() - 1)) + "'");
    }
    const UnpackedChunk inner = unpack_chunk(bytes.substr(kMap3dHead.size()), "zstd", kMost);
    if (!inner.whole) throw std::runtime_error("is cut off; make or copy it again");
    ByteReader reader(inner.bytes);
    Map3d map;
    map.voxels = take_voxels(reader);
    map.ground = take_ground(reader);
    if (reader.rest() != 0) throw std::runtime_error("holds more than a map; make it again");
    return map;
  } catch (const std::exception& error) {
    throw std::runtime_error(name + ": " + error.what());
  }
}

}  // namespace castaway::testbed
