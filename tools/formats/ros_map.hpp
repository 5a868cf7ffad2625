/// Occupancy maps as ROS' map_server keeps them: a picture and a few numbers.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "tools/formats/images/gray_image.hpp"

namespace castaway::testbed {

/// A map. Cell (column, row) covers, before the turn by `origin_yaw` about the origin,
/// `[origin + (column, row) * resolution, origin + (column + 1, row + 1) * resolution)`.
struct RosMap {
  std::string name;
  int width = 0;                   ///< [cells]
  int height = 0;                  ///< [cells]
  double resolution = 0.05;        ///< [m]
  double origin_x = 0.0;           ///< [m] Lower left corner in map.
  double origin_y = 0.0;           ///< [m]
  double origin_yaw = 0.0;         ///< [rad]
  std::vector<std::int8_t> cells;  ///< -1 unknown, 0 free ... 100 occupied; row 0 at the bottom.
  std::vector<std::string> warnings{};  ///< What is odd about its file.

  [[nodiscard]] std::int8_t at(int column, int row) const {
    return cells[static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
                 static_cast<std::size_t>(column)];
  }
  /// A point of the grid, in cells from its lower left corner, in map. [m]
  [[nodiscard]] Eigen::Vector2d to_map(const Eigen::Vector2d& cells_from_corner) const;
};

/// How grey becomes occupancy, p = (max - grey) / max, or grey / max if `negate`.
enum class MapMode {
  kTrinary,  ///< p >= occupied_thresh: 100; p <= free_thresh: 0; else unknown.
  kScale,    ///< As trinary, but between the thresholds 0 to 100, linear, rounded.
  kRaw,      ///< Grey of 0 to 100 (of 255) is the value, more is unknown; `negate` has no effect.
};

/// What a map's YAML file says beside the name of the picture.
struct RosMapHeader {
  double resolution = 0.05;  ///< [m] Edge of a cell.
  double origin_x = 0.0;     ///< [m] Lower left corner in map.
  double origin_y = 0.0;     ///< [m]
  double origin_yaw = 0.0;   ///< [rad]
  MapMode mode = MapMode::kTrinary;
  bool negate = false;            ///< True: white is occupied.
  double occupied_thresh = 0.65;  ///< In [0, 1].
  double free_thresh = 0.196;     ///< In [0, 1].
};

/// The map in a picture, whose row 0 is the largest y.
RosMap make_ros_map(const GrayImage& image, const RosMapHeader& header, std::string name);

/// The picture of a map in trinary mode: 0 where occupancy is at least 65, 254 where it is 0 to 19,
/// 205 elsewhere.
GrayImage map_image(const RosMap& map);

/// The YAML file of a map whose picture is `image`, a path relative to it.
std::string ros_map_yaml(const RosMap& map, const std::string& image);

/// Writes `<stem>.yaml` and `<stem>.pgm` beside it; the same map gives the same bytes. `yaml_path`
/// names the YAML file.
void write_ros_map(const RosMap& map, const std::filesystem::path& yaml_path);

}  // namespace castaway::testbed
