/// A scan with everything that there is to learn from it.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "tools/records/hit_legend.hpp"
#include "tools/records/place_scores.hpp"
#include "tools/run/run_sink.hpp"

namespace castaway::testbed {

/// Labels of a scan.
struct ScanRow {
  double stamp_s = 0.0;
  std::optional<SE2> T_map_base;         ///< True pose at the stamp.
  SE2 T_odom_base;                       ///< Newest odometry when the scan is delivered.
  std::optional<double> since_kidnap_s;  ///< Since the last kidnap was over; nothing before one.
  bool held = false;                     ///< The robot is in somebody's hands.
  bool torn = false;                     ///< A kidnap falls between the first beam and the last.
  double occluded = 0.0;                 ///< Share of the beams that end on what `hides_map`.
  std::optional<double> ambiguity;       ///< Likeness of the place most like this one, [0, 1].
  std::vector<std::uint8_t> lost;        ///< By localizer: 1 if it is off or has no estimate.
  std::vector<std::uint8_t> classes;     ///< By beam: `BeamClass`.
  std::vector<std::int32_t> hits;        ///< By beam: `HitLegend::id_of`.
};

/// What labels are made with.
struct LabelContext {
  HitLegend legend;
  PlaceScores ambiguity;  ///< Of the map; empty: nobody knows.
};

/// Labels scans in the order in which a run delivers events and scans.
class ScanLabeller {
 public:
  explicit ScanLabeller(std::shared_ptr<const LabelContext> context)
      : context_(std::move(context)) {}  // Shared by the sinks of a run.

  void add(const RunEvent& event);
  [[nodiscard]] ScanRow row_of(const ScanRecord& record) const;

 private:
  std::shared_ptr<const LabelContext> context_;
  std::vector<RunEvent> kidnaps_;
  std::optional<Stamp> picked_up_;  ///< Nothing while it stands.
};

/// Roll, pitch and yaw of a rotation R_z(yaw) R_y(pitch) R_x(roll). [rad]
Eigen::Vector3d roll_pitch_yaw(const Eigen::Matrix3d& rotation);

/// A localizer is off from here on: 0.5 m or 0.35 rad from the truth, or without an estimate.
bool is_off(const LocalizerRecord& localizer, const SE2& T_map_base_true);

}  // namespace castaway::testbed
