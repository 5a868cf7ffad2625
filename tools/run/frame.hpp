/// What a source delivers: sensor data as the hardware would send it, and the truth beside it.
#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "localization/localizer.hpp"
#include "tools/run/event.hpp"

namespace castaway::testbed {

using localization::LaserScan;
using localization::Odometry;
using localization::SE2;
using localization::Stamp;

/// [s] of a stamp or a duration.
inline double seconds(Stamp stamp) { return std::chrono::duration<double>(stamp).count(); }

/// Where a person was.
struct PersonTruth {
  int id = 0;
  SE2 T_map_person;                                    ///< x where it faces.
  Eigen::Vector2d velocity = Eigen::Vector2d::Zero();  ///< [m/s] In map.
  double gap_m = 0.0;  ///< Between the robot's outline and its body; <= 0: they touch.
};

/// The people about at a scan.
struct PeopleTruth {
  std::vector<PersonTruth> people;
  double beams_on_people = 0.0;  ///< Share of the scan's beams that ended on people.
};

/// A point that a beam measured.
struct CloudPoint {
  Eigen::Vector3f p_base = Eigen::Vector3f::Zero();  ///< [m]
  float intensity = 0.0F;
  int label = 0;
};

/// What is known of a scan besides what a localizer is told.
struct ScanTruth {
  std::string frame;               ///< Frame id of the lidar.
  std::vector<float> intensities;  ///< By beam; empty if the lidar tells none.
  std::vector<int> labels;         ///< By beam: what it hit. Empty: nobody knows.
  std::vector<CloudPoint> cloud;   ///< Returns of all layers; empty unless they are asked for.
};

/// A scan with the true pose of base at the scan's stamp, where it is known.
struct ScanFrame {
  LaserScan scan;
  std::optional<SE2> T_map_base_true;
  PeopleTruth people{};  ///< Empty where there are none, or nobody knows.
  ScanTruth truth{};
};

/// An odometry reading with the true pose of base at its stamp, where it is known.
struct OdometryFrame {
  Odometry odometry;
  std::optional<SE2> T_map_base_true;
};

/// One delivery of a source. Deliveries come in order of `stamp`, which for a scan is the time of
/// its last beam.
struct Frame {
  Stamp stamp{};
  std::variant<OdometryFrame, ScanFrame, RunEvent> data;
};

}  // namespace castaway::testbed
