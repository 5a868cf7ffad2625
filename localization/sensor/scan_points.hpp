/// A scan as points in base coordinates, which can be compared with a map from any pose.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "castaway/readings.hpp"
#include "localization/geometry/transform_buffer.hpp"

namespace castaway::localization {

/// Selection of beams.
struct BeamSelection {
  int max_beams = 90;       ///< Largest number of beams, evenly spread over the valid ones.
  double max_range = 40.0;  ///< [m] Longer returns are ignored.
  int max_tilted = 60;      ///< Most beams of a 3-D lidar's other layers that end on what is steep.
  int max_flat = 20;        ///< Most of its beams that end on what is flat: ground, ceilings.
};

/// @throws std::invalid_argument if a value is out of range.
void validate(const BeamSelection& selection);

/// True for a range within the limits of the lidar and of the selection.
bool is_valid_range(const LaserScan& scan, const BeamSelection& selection, double range);

/// Beams by what they tell.
enum class BeamKind : std::uint8_t {
  kLevel,   ///< Of a planar lidar, or of the most level layer of another.
  kTilted,  ///< Of another layer.
  kFlat,    ///< Ends on a flat surface: ground or a ceiling, which looks alike everywhere.
};

/// Valid beams in the frame of base at a reference time, as a structure of arrays of the same
/// length. A beam runs from its origin (the lidar's position at its time) to its end point. A
/// planar map uses only x and y.
struct ScanPoints {
  std::vector<float> x;           ///< [m] End points.
  std::vector<float> y;           ///< [m]
  std::vector<float> z;           ///< [m]
  std::vector<float> origin_x;    ///< [m]
  std::vector<float> origin_y;    ///< [m]
  std::vector<float> origin_z;    ///< [m]
  std::vector<float> range;       ///< [m] Length of the beam in the plane.
  std::vector<BeamKind> kinds{};  ///< Empty: all are level.
  /// Direction up in base, as an inertial measurement unit knows it; nothing without one.
  std::optional<Eigen::Vector3f> up{};
  double valid_share = 1.0;  ///< Share of the lidar's beams with a valid range.

  [[nodiscard]] std::size_t size() const { return x.size(); }
  [[nodiscard]] bool empty() const { return x.empty(); }
  [[nodiscard]] BeamKind kind(std::size_t i) const {
    return kinds.empty() ? BeamKind::kLevel : kinds[i];
  }
};

/// Appends a beam from a lidar's origin to a point in its frame; does not append its kind.
void append_beam(ScanPoints& points, const Eigen::Isometry3d& T_base_laser,
                 const Eigen::Vector3d& end);

/// Projects a scan into the frame of base at `reference`: every beam starts at the lidar's pose at
/// the beam's own time (3-D mount, motion from `T_odom_base`). Beams without return, NaN, and
/// ranges outside of the lidar's limits are dropped. Returns nothing if the motion at the scan's or
/// the reference time is unknown.
std::optional<ScanPoints> project_scan(const LaserScan& scan, const TransformBuffer& T_odom_base,
                                       Stamp reference, const BeamSelection& selection);

/// Indices of at most `count` of `size` items, evenly spread, in ascending order.
std::vector<std::size_t> even_indices(std::size_t size, int count);

/// The points of these indices, in their order.
ScanPoints points_at(const ScanPoints& points, const std::vector<std::size_t>& indices);

/// Returns at most `count` of the points, evenly spread over the scan.
ScanPoints thin(const ScanPoints& points, int count);

/// The farthest `share` of the points in their order; at least one if there are any.
ScanPoints farthest_points(const ScanPoints& points, double share);

}  // namespace castaway::localization
