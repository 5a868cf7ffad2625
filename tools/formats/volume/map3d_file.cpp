#include "tools/formats/volume/map3d_file.hpp"

#include <bit>
#include <cstring>
#include <stdexcept>
#include <vector>

#include "tools/formats/varint.hpp"
#include "tools/formats/volume/packed_bytes.hpp"

namespace castaway::testbed {
namespace {

using localization::ElevationMap;
using localization::GroundSurface;
using localization::VoxelMap;

constexpr std::size_t kMostPerCell = 255;

void put_voxels(ByteWriter& writer, const VoxelMap& map) {
  std::string keys;
  localization::VoxelKey last = 0;
  for (const localization::VoxelKey key : map.keys) {
    append_varint(keys, key - last);
    last = key;
  }
  writer.put(map.resolution);
  writer.put(static_cast<std::uint64_t>(map.size()));
  writer.put_text(keys);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (const auto& offset : map.offsets) writer.put(offset[axis]);
  }
  for (const std::uint8_t up : map.faces_up) writer.put(up);
}

VoxelMap take_voxels(ByteReader& reader) {
  VoxelMap map;
  map.resolution = reader.take<double>();
  const auto count = reader.take_count(4);  // At least four bytes each follow.
  VarintReader keys(reader.take_text());
  localization::VoxelKey last = 0;
  for (std::size_t i = 0; i < count; ++i) map.keys.push_back(last += keys.next());
  map.offsets.resize(count);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (auto& offset : map.offsets) offset[axis] = reader.take<std::uint8_t>();
  }
  map.faces_up.resize(count);
  for (std::uint8_t& up : map.faces_up) up = reader.take<std::uint8_t>();
  validate(map);
  return map;
}

void put_ground(ByteWriter& writer, const ElevationMap& map) {
  writer.put(static_cast<std::uint32_t>(map.frame.width));
  writer.put(static_cast<std::uint32_t>(map.frame.height));
  for (const double value : {map.frame.resolution, map.frame.T_map_grid.x, map.frame.T_map_grid.y,
                             map.frame.T_map_grid.yaw}) {
    writer.put(value);
  }
  for (std::size_t i = 0; i + 1 < map.first.size(); ++i) {
    const std::uint32_t count = map.first[i + 1] - map.first[i];
    if (count > kMostPerCell) throw std::invalid_argument("a cell has more than 255 surfaces");
    writer.put(static_cast<std::uint8_t>(count));
  }
  for (const GroundSurface& s : map.surfaces) writer.put(s.z);
  for (const GroundSurface& s : map.surfaces) writer.put(s.slope_x);
  for (const GroundSurface& s : map.surfaces) writer.put(s.slope_y);
  for (const GroundSurface& s : map.surfaces) writer.put(s.clearance);
  for (const GroundSurface& s : map.surfaces) writer.put(s.level);
  for (const GroundSurface& s : map.surfaces) writer.put(static_cast<std::uint8_t>(s.drivable));
  writer.put(static_cast<std::uint8_t>(map.levels.size()));
  for (const float level : map.levels) writer.put(level);
}

localization::GridFrame take_frame(ByteReader& reader) {
  localization::GridFrame frame;
  const auto width = reader.take<std::uint32_t>();
  const auto height = reader.take<std::uint32_t>();
  if (std::uint64_t{width} * height > reader.left()) {
    throw std::runtime_error("states more cells than it holds");
  }
  frame.width = static_cast<int>(width);
  frame.height = static_cast<int>(height);
  for (double* value :
       {&frame.resolution, &frame.T_map_grid.x, &frame.T_map_grid.y, &frame.T_map_grid.yaw}) {
    *value = reader.take<double>();
  }
  return frame;
}

ElevationMap take_ground(ByteReader& reader) {
  ElevationMap map;
  map.frame = take_frame(reader);
  map.first.assign(1, 0);
  for (std::size_t i = 0; i < map.frame.size(); ++i) {
    map.first.push_back(map.first.back() + reader.take<std::uint8_t>());
  }
  reader.require(std::uint64_t{18} * map.first.back());
  map.surfaces.resize(map.first.back());
  for (GroundSurface& s : map.surfaces) s.z = reader.take<float>();
  for (GroundSurface& s : map.surfaces) s.slope_x = reader.take<float>();
  for (GroundSurface& s : map.surfaces) s.slope_y = reader.take<float>();
  for (GroundSurface& s : map.surfaces) s.clearance = reader.take<float>();
  for (GroundSurface& s : map.surfaces) s.level = reader.take<std::uint8_t>();
  for (GroundSurface& s : map.surfaces) s.drivable = reader.take<std::uint8_t>() != 0;
  map.levels.resize(reader.take<std::uint8_t>());
  for (float& level : map.levels) level = reader.take<float>();
  validate(map);
  return map;
}

}  // namespace

std::string encode_map3d(const Map3d& map) {
  ByteWriter writer;
  put_voxels(writer, map.voxels);
  put_ground(writer, map.ground);
  return std::string(kMap3dHead) + pack_bytes(writer.bytes());
}

Map3d decode_map3d(std::string_view bytes, const std::string& name) {
  try {
    if (!bytes.starts_with(kMap3dHead)) {
      throw std::runtime_error("is no 3-D map of this castaway: it does not begin with '" +
                               std::string(kMap3dHead.substr(0, kMap3dHead.size() - 1)) + "'");
    }
    const std::string unpacked = unpack_bytes(bytes.substr(kMap3dHead.size()));
    ByteReader reader(unpacked);
    Map3d map;
    map.voxels = take_voxels(reader);
    map.ground = take_ground(reader);
    if (reader.left() != 0) throw std::runtime_error("holds more than a map; make it again");
    return map;
  } catch (const std::exception& error) {
    throw std::runtime_error(name + ": " + error.what());
  }
}

}  // namespace castaway::testbed
