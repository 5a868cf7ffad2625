/// What a simulation or a log delivers: sensor data as the hardware would send it, and the truth
/// beside it.
#pragma once

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

/// The true pose of base.
struct TruePose {
  SE2 T_map_base;
  /// Height, roll and pitch, in runs on several floors.
  std::optional<Eigen::Isometry3d> T_footprint_base{};

  TruePose() = default;
  /// Implicit: on one floor it is a pose in the plane.
  TruePose(const SE2& in_plane) : T_map_base(in_plane) {}

  /// [m] Height of base; 0 on one floor.
  [[nodiscard]] double z() const {
    return T_footprint_base ? T_footprint_base->translation().z() : 0.0;
  }
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
  std::optional<TruePose> true_pose;
  PeopleTruth people{};  ///< Empty if there are none or they are unknown.
  ScanTruth truth{};
};

/// An odometry reading with the true pose of base at its stamp, where it is known.
struct OdometryFrame {
  Odometry odometry;
  std::optional<TruePose> true_pose;
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

}  // namespace castaway::testbed

namespace castaway {

using testbed::BaseVelocity;
using testbed::CloudPoint;
using testbed::ImuFrame;
using testbed::OdometryFrame;
using testbed::PeopleTruth;
using testbed::PersonTruth;
using testbed::ScanFrame;
using testbed::ScanTruth;

/// Something that happened to the robot, as a row of events.csv. Localizers do not see it.
struct Event {
  Stamp stamp{};
  std::string kind;                 ///< "kidnap", "pick-up", "collision", "fault on", ...
  std::string detail;               ///< "teleport", "person 3", ...; may be empty.
  std::optional<Pose2> T_map_from;  ///< True pose of base before.
  std::optional<Pose2> T_map_to;    ///< True pose of base after.
  std::optional<Stamp> since{};     ///< Its beginning; nothing: an instantaneous event.
};

/// One delivery of a simulation. Deliveries come in order of `stamp`, which for a scan is the time
/// of its last beam.
struct Frame {
  Stamp stamp{};
  std::variant<OdometryFrame, ScanFrame, Event, ImuFrame> data;
};

}  // namespace castaway
