/// What a simulation or a log delivers: sensor data as the hardware would send it, and the truth
/// beside it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "castaway/pose.hpp"
#include "castaway/readings.hpp"
#include "castaway/stamp.hpp"

namespace castaway::testbed {

using localization::LaserScan;
using localization::Odometry;
using localization::SE2;
using localization::seconds;
using localization::Stamp;

/// Kinds of events.
enum class EventKind : std::uint8_t {
  kKidnap,     ///< The robot was moved without odometry.
  kPickUp,     ///< It was lifted; a kidnap follows.
  kCollision,  ///< Contact with anything but the floor.
  kFaultOn,    ///< A sensor fault begins.
  kFaultOff,   ///< A sensor fault ends.
  kDriving,    ///< A recovery behaviour of the driver, or an emergency stop.
  kVoid,       ///< The run is void: it is not scored.
  kAlarmOn,    ///< A localizer reports that it is lost.
  kAlarmOff,   ///< A localizer no longer reports that it is lost.
  kRecovery,   ///< A localizer is right again after a kidnap.
  kWarning,    ///< A remark for the reader of the run.
  kOperator,   ///< An operator restarted a localizer, or switched it off or on.
  kFailure,    ///< A localizer failed; the run goes on without it.
  kNode,       ///< A node of ROS 2 came, went or was not understood.
  kWorld,      ///< Something was put into the world, taken away, opened or closed; people came.
};

/// The name in files: "kidnap", "pick-up", "collision", "fault on", ...
std::string event_name(EventKind kind);

/// The kind with this name; nothing for other text.
std::optional<EventKind> event_kind(const std::string& name);

/// Something that happened to the robot. Localizers do not see it.
struct RunEvent {
  Stamp stamp{};
  EventKind kind = EventKind::kKidnap;
  std::string detail;                      ///< Details, e.g. "teleport", "person 3".
  std::optional<SE2> T_map_from;           ///< True pose of base before.
  std::optional<SE2> T_map_to;             ///< True pose of base after.
  std::optional<Stamp> since{};            ///< Its beginning; nothing: an instantaneous event.
  std::string localizer{};                 ///< That it is about; empty: it is about the run.
  std::string object{};                    ///< Of the world, that changed; empty: none.
  std::vector<Eigen::Vector2d> outline{};  ///< [m] Of what stands there now, in map; may be empty.
  Eigen::Vector2d outline_z{0.0, 0.0};     ///< [m] Its lower and its upper end.
  /// [m] Of a kidnap in a run on several floors: the ground before and after.
  std::optional<Eigen::Vector2d> heights{};

  /// Its beginning.
  [[nodiscard]] Stamp begun() const { return since.value_or(stamp); }
};

/// The state of a person.
struct PersonTruth {
  int id = 0;
  SE2 T_map_person;                                    ///< x points where the person faces.
  Eigen::Vector2d velocity = Eigen::Vector2d::Zero();  ///< [m/s] In map.
  double gap_m = 0.0;  ///< Gap between the outlines of robot and person; <= 0: contact.
};

/// The people in the world at a scan.
struct PeopleTruth {
  std::vector<PersonTruth> people;
  double beams_on_people = 0.0;  ///< Share of the scan's beams that hit people.
};

/// A point that a beam measured.
struct CloudPoint {
  Eigen::Vector3f p_base = Eigen::Vector3f::Zero();  ///< [m]
  float intensity = 0.0F;
  int label = 0;
};

/// Ground truth of a scan, which localizers do not see.
struct ScanTruth {
  std::string frame;               ///< Frame id of the lidar.
  std::vector<float> intensities;  ///< By beam; empty if the lidar reports none.
  std::vector<int> labels;         ///< By beam: label of what it hit. Empty if unknown.
  std::vector<CloudPoint> cloud;   ///< Returns of all layers; empty unless requested.
};

/// A scan with the true pose of base at the scan's stamp, where it is known.
struct ScanFrame {
  LaserScan scan;
  std::optional<SE2> T_map_base_true;
  PeopleTruth people{};  ///< Empty if there are none or they are unknown.
  ScanTruth truth{};
  /// Height, roll and pitch of base, in runs on several floors.
  std::optional<Eigen::Isometry3d> T_footprint_base_true{};
};

/// An odometry reading with the true pose of base at its stamp, where it is known.
struct OdometryFrame {
  Odometry odometry;
  std::optional<SE2> T_map_base_true;
  /// Height, roll and pitch of base, in runs on several floors.
  std::optional<Eigen::Isometry3d> T_footprint_base_true{};
};

/// A reading of an inertial measurement unit.
struct ImuFrame {
  localization::Imu imu;
};

/// A velocity of the base, as it is commanded.
struct BaseVelocity {
  double v = 0.0;  ///< [m/s] Forward.
  double w = 0.0;  ///< [rad/s] Counter-clockwise.
};

/// One delivery of a source. Deliveries come in order of `stamp`, which for a scan is the time of
/// its last beam.
struct Frame {
  Stamp stamp{};
  std::variant<OdometryFrame, ScanFrame, RunEvent, ImuFrame> data;
};

}  // namespace castaway::testbed

namespace castaway {

using Event = testbed::RunEvent;
using testbed::BaseVelocity;
using testbed::CloudPoint;
using testbed::event_name;
using testbed::EventKind;
using testbed::Frame;
using testbed::ImuFrame;
using testbed::OdometryFrame;
using testbed::PeopleTruth;
using testbed::PersonTruth;
using testbed::ScanFrame;
using testbed::ScanTruth;

}  // namespace castaway
