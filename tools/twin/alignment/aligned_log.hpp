/// A recorded log whose scans are aligned with its map.
#pragma once

#include <string>
#include <vector>

#include "localization/geometry/transform_buffer.hpp"
#include "localization/map/occupancy_grid.hpp"
#include "tools/batch/evaluate/evaluation.hpp"
#include "tools/twin/alignment/odometry_step.hpp"
#include "tools/twin/alignment/wall_offsets.hpp"

namespace castaway::testbed {

/// Poses that the alignment begins with.
enum class AlignBy {
  kAuto,    ///< Those of the log where most of its scans have one, otherwise `mh_amcl`.
  kTruth,   ///< Reference poses of the log (TRUEPOS, ground truth of a bag).
  kMhAmcl,  ///< `mh_amcl` from an unknown start, and backwards from its first certain pose.
};

/// Of "auto", "truth" and "mh_amcl". Throws std::invalid_argument for any other text.
AlignBy parse_align(const std::string& text);

/// A scan and its pose on the map.
struct AlignedScan {
  LaserScan scan;
  SE2 T_map_base;       ///< Pose of base at the scan's stamp that fits the map best.
  bool breaks = false;  ///< The robot was moved since the scan before, or odometry was reset.
};

/// The scans of a log's first lidar, in order of time; at most `kMostAligned`, evenly spread.
struct AlignedLog {
  std::string name;
  localization::OccupancyGrid grid;
  std::vector<AlignedScan> scans;
  std::vector<Stamp> stamps;                  ///< Of all scans of this lidar, those left out, too.
  Stamp stamp_correction{};                   ///< Added to the stamps of the log.
  localization::TransformBuffer T_odom_base;  ///< Of the whole log, as measured.
  /// The same with the systematic errors corrected; the poses of a scan's beams come from it.
  localization::TransformBuffer T_path_base;
  double odometry_period_s = 0.0;  ///< [s] Median between two readings.
  bool by_truth = false;           ///< Aligned from reference poses.
  std::size_t left_out = 0;        ///< Scans whose pose is unknown.
  SE2 T_start_base;                ///< Mean of the aligned poses, seen from where they began.
  double on_walls = 0.0;  ///< Share of end points within 0.2 m of a wall, median over scans.
};

/// Corrections of the scans before they are matched.
struct ScanCorrection {
  Stamp stamp{};  ///< Added to the stamps.
  /// Surfaces of the walls. Matching puts end points on the centres of wall cells, and walls
  /// reflect at their surface: without this the robot seems to drive too far between two walls.
  std::optional<WallOffsets> walls;
  DriveErrors drive;  ///< Of the motion within a scan.
  /// Where aligned poses usually are, seen from the reference poses: reference poses are those of
  /// the robot, and aligned ones rest on the stated mount of the lidar.
  SE2 T_reference_base;
};

/// Aligns a log: reference poses, or those of `mh_amcl`, are refined by matching each scan to the
/// map, within some centimetres. The scans of the result have corrected stamps, and ranges as
/// measured. Throws std::runtime_error if the log has fewer than `kFewestAligned` scans with a
/// pose, if reference poses are wanted and missing, or if the scans do not lie on walls
/// (`kLeastOnWalls`).
AlignedLog align_log(const RecordedPlace& place, AlignBy by, const ScanCorrection& correction = {});

/// Moves aligned poses back by the translation that they made on average. How far walls lie behind
/// the borders of their cells, and how far ahead a lidar is that looks ahead, cannot be told apart:
/// where both are found from aligned poses, repeated alignments add to both.
void move_back(AlignedLog& log);

inline constexpr std::size_t kFewestAligned = 50;
inline constexpr std::size_t kMostAligned = 6000;
inline constexpr double kLeastOnWalls = 0.55;

}  // namespace castaway::testbed
