#include "tools/base/formats/points/point_cloud.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <string_view>

#include "tools/base/files/file.hpp"
#include "tools/base/formats/points/pcd.hpp"
#include "tools/base/formats/points/ply.hpp"

namespace castaway::testbed {
namespace {

/// True if an entry of a PCD header follows the comments at the begin.
bool begins_as_pcd(std::string_view bytes) {
  const auto skip_blanks = [&] {
    bytes.remove_prefix(std::min(bytes.find_first_not_of(" \t\r\n"), bytes.size()));
  };
  for (skip_blanks(); bytes.starts_with('#'); skip_blanks()) {
    bytes.remove_prefix(std::min(bytes.find('\n'), bytes.size()));
  }
  return bytes.starts_with("VERSION") || bytes.starts_with("FIELDS") ||
         bytes.starts_with("COLUMNS");
}

std::vector<Eigen::Vector3d> decode_points(std::string_view bytes, const std::string& name) {
  if (bytes.starts_with("ply")) return decode_ply(bytes, name);
  if (begins_as_pcd(bytes)) return decode_pcd(bytes, name);
  throw std::runtime_error(name + ": neither PCD nor PLY; convert it, e.g. with CloudCompare");
}

}  // namespace

std::vector<Eigen::Vector3d> read_point_cloud(const std::filesystem::path& file) {
  std::vector<Eigen::Vector3d> points = decode_points(read_file(file), file.string());
  std::erase_if(points, [](const Eigen::Vector3d& point) { return !point.allFinite(); });
  return points;
}

}  // namespace castaway::testbed
