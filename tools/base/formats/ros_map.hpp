/// Occupancy maps in the format of ROS' map_server: an image and a few numbers.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "tools/base/formats/images/gray_image.hpp"

namespace castaway::testbed {

/// A map. Before the rotation by `origin_yaw` about the origin, cell (column, row) covers `[origin
/// + (column, row) * resolution, origin + (column + 1, row + 1) * resolution)`.
struct RosMap {
  std::string name;
  int width = 0;                   ///< [cells]
  int height = 0;                  ///< [cells]
  double resolution = 0.05;        ///< [m]
  double origin_x = 0.0;           ///< [m] Lower left corner in map.
  double origin_y = 0.0;           ///< [m]
  double origin_yaw = 0.0;         ///< [rad]
  std::vector<std::int8_t> cells;  ///< -1 unknown, 0 free ... 100 occupied; row 0 at the bottom.
  std::vector<std::string> warnings{};  ///< Peculiarities of the map's file.

  [[nodiscard]] std::int8_t at(int column, int row) const {
    return cells[static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
                 static_cast<std::size_t>(column)];
  }
  /// Converts a point in cells from the grid's lower left corner to map [m].
  [[nodiscard]] Eigen::Vector2d to_map(const Eigen::Vector2d& cells_from_corner) const;
};

/// How grey values become occupancy, p = (max - grey) / max, or grey / max if `negate`.
enum class MapMode {
  kTrinary,  ///< p >= occupied_thresh: 100; p <= free_thresh: 0; else unknown.
  kScale,    ///< As trinary, but linear from 0 to 100 and rounded between the thresholds.
  kRaw,      ///< Grey values 0 to 100 (of 255) are occupancy, larger ones unknown; `negate` is
             ///< ignored.
};

/// Values of a map's YAML file besides the image's name.
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

/// Converts an image, whose row 0 is the largest y, to a map.
RosMap make_ros_map(const GrayImage& image, const RosMapHeader& header, std::string name);

/// The image of a map in trinary mode: 0 for an occupancy of at least 65, 254 for 0 to 19, 205
/// otherwise.
GrayImage map_image(const RosMap& map);

/// The part of a map from a cell on, [cells]; it lies where it lay.
RosMap part_of(const RosMap& map, const Eigen::Vector2i& from, const Eigen::Vector2i& size);

/// What pictures and pages show of a map: what is known and 1 m around it, if that is less than
/// four fifths of a side; otherwise all.
RosMap known_part(const RosMap& map);

/// Text of the YAML file of a map; `image` is a path relative to that file.
std::string ros_map_yaml(const RosMap& map, const std::string& image);

/// Writes the YAML file `yaml_path` and `<stem>.pgm` beside it. The same map gives the same bytes.
void write_ros_map(const RosMap& map, const std::filesystem::path& yaml_path);

}  // namespace castaway::testbed
