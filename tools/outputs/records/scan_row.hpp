/// A scan with its labels, for learning.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "tools/outputs/records/hit_legend.hpp"
#include "tools/outputs/records/place_scores.hpp"
#include "tools/run/run_sink.hpp"

namespace castaway::testbed {

/// Labels of a scan.
struct ScanRow {
  double stamp_s = 0.0;
  std::optional<SE2> T_map_base;         ///< True pose of base at the stamp.
  SE2 T_odom_base;                       ///< Newest odometry when the scan was delivered.
  std::optional<double> since_kidnap_s;  ///< Since the end of the last kidnap; nothing before the
                                         ///< first one.
  bool held = false;                     ///< The robot is being carried.
  bool torn = false;                     ///< A kidnap happened between the first and the last beam.
  double occluded = 0.0;                 ///< Share of beams that end on a class for which
                                         ///< `hides_map` is true.
  std::optional<double> ambiguity;       ///< [0, 1] Similarity of the most similar other place.
  std::vector<std::uint8_t> lost;        ///< By localizer: 1 if `is_off`.
  std::vector<std::uint8_t> classes;     ///< By beam: `BeamClass`.
  std::vector<std::int32_t> hits;        ///< By beam: `HitLegend::id_of`.
};

/// Inputs of the labels.
struct LabelContext {
  HitLegend legend;
  PlaceScores ambiguity;  ///< Scores of the map; empty if unknown.
};

/// Labels scans. Events and scans must be added in the order of their delivery.
class ScanLabeller {
 public:
  explicit ScanLabeller(std::shared_ptr<const LabelContext> context)
      : context_(std::move(context)) {}  // Shared by the sinks of a run.

  void add(const RunEvent& event);
  [[nodiscard]] ScanRow row_of(const ScanRecord& record) const;

 private:
  /// Fills in the time since the last kidnap, and whether one is under way.
  void add_kidnaps(const ScanRecord& record, ScanRow& row) const;

  std::shared_ptr<const LabelContext> context_;
  std::vector<RunEvent> kidnaps_;
  std::optional<Stamp> picked_up_;  ///< Nothing while the robot stands on the floor.
};

/// Roll, pitch and yaw [rad] of a rotation R_z(yaw) R_y(pitch) R_x(roll).
Eigen::Vector3d roll_pitch_yaw(const Eigen::Matrix3d& rotation);

/// z [m], roll and pitch [rad] of base relative to its planar pose; nothing where these are
/// unknown.
std::optional<Eigen::Vector3d> height_roll_pitch(
    const std::optional<Eigen::Isometry3d>& T_footprint_base);

/// True if a localizer has no estimate or is at least 0.5 m or 0.35 rad from the record's true
/// pose, which is known.
bool is_off(const LocalizerRecord& localizer, const ScanRecord& record);

}  // namespace castaway::testbed
