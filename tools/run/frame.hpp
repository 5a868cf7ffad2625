/// What a source delivers: sensor data as the hardware would send it, and events.
#pragma once

#include <optional>
#include <variant>

#include "castaway/frame.hpp"
#include "castaway/localizer.hpp"
#include "tools/run/event.hpp"

namespace castaway::testbed {

/// The planar part of a true pose, and the rest of it; nothing where it is unknown.
inline std::optional<SE2> T_map_base_of(const std::optional<TruePose>& pose) {
  return pose ? std::optional(pose->T_map_base) : std::nullopt;
}
inline std::optional<Eigen::Isometry3d> T_footprint_base_of(const std::optional<TruePose>& pose) {
  return pose ? pose->T_footprint_base : std::nullopt;
}

/// The stamp that a delivery's data states; of a scan, that of its first beam.
inline Stamp& own_stamp(OdometryFrame& frame) { return frame.odometry.stamp; }
inline Stamp& own_stamp(ScanFrame& frame) { return frame.scan.stamp; }
inline Stamp& own_stamp(RunEvent& event) { return event.stamp; }
inline Stamp& own_stamp(ImuFrame& frame) { return frame.imu.stamp; }

/// Gives a localizer a reading that it takes as it is.
inline void give(const ImuFrame& frame, localization::Localizer& localizer) {
  localizer.on_imu(frame.imu);
}

/// One delivery of a source. Deliveries come in order of `stamp`, which for a scan is the time of
/// its last beam.
struct Frame {
  Stamp stamp{};
  std::variant<OdometryFrame, ScanFrame, RunEvent, ImuFrame> data;
};

}  // namespace castaway::testbed
