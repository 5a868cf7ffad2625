#include "tools/build/map3d/map3d_files.hpp"

#include <stdexcept>

#include "tools/base/files/file.hpp"
#include "tools/base/formats/points/point_cloud.hpp"
#include "tools/base/formats/volume/octomap_file.hpp"

namespace castaway::testbed {
namespace {

Map3d map3d_of(const std::filesystem::path& file, const Map3dOptions& options) {
  if (is_cloud(file)) return survey_map3d(read_point_cloud(file), options);
  const std::string bytes = read_file(file);
  if (file.extension() == ".map3d") return decode_map3d(bytes, file.string());
  return survey_map3d(decode_octomap(bytes, file.string()), options);
}

}  // namespace

bool is_map3d_target(const std::filesystem::path& file) {
  const std::string end = file.extension().string();
  return end == ".map3d" || end == ".bt" || end == ".ot";
}

bool is_cloud(const std::filesystem::path& file) {
  return file.extension() == ".pcd" || file.extension() == ".ply";
}

bool is_map3d_source(const std::filesystem::path& file) {
  return is_map3d_target(file) || is_cloud(file);
}

void require_map3d_source(const std::filesystem::path& file) {
  if (is_map3d_source(file)) return;
  throw std::invalid_argument("--map3d " + file.string() +
                              ": a 3-D map is a .map3d, .bt, .ot, .pcd or .ply file");
}

Map3d read_map3d_file(const std::filesystem::path& file, const Map3dOptions& options) {
  try {
    return map3d_of(file, options);
  } catch (const std::invalid_argument& error) {  // Of the survey, which knows no file.
    throw std::runtime_error(file.string() + ": " + error.what());
  }
}

std::string encode_map3d_file(const Map3d& map, const std::filesystem::path& file) {
  const std::string end = file.extension().string();
  if (end == ".bt") return encode_octomap(map.voxels, OctomapKind::kBinary);
  if (end == ".ot") return encode_octomap(map.voxels, OctomapKind::kFull);
  return encode_map3d(map);
}

}  // namespace castaway::testbed
