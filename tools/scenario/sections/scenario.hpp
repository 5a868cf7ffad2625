/// A scenario: everything that a run depends on, as plain data with runnable defaults.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <Eigen/Core>

#include "localization/amcl.hpp"
#include "localization/mh_amcl_config.hpp"
#include "localization/paper/published/published_config.hpp"
#include "sim/difference/difference.hpp"
#include "sim/events/fault.hpp"
#include "sim/events/kidnap.hpp"
#include "sim/people/people_config.hpp"
#include "sim/robot/bodies/twist_ramp.hpp"
#include "sim/sensor/wheel_odometry.hpp"
#include "tools/metrics/expectation.hpp"
#include "tools/pictures/picture_config.hpp"
#include "tools/ros/bag_options.hpp"
#include "tools/scenario/yaml/yaml_tree.hpp"

namespace castaway::testbed {

inline constexpr double kLongest = 1e7;   ///< [s] 115 days.
inline constexpr double kFarthest = 1e7;  ///< [m] UTM coordinates stay below.

/// The robot.
struct RobotSpec {
  std::string file = "waffle";                   ///< A robot's name, or a URDF or xacro file.
  std::map<std::string, std::string> arguments;  ///< Of the xacro file.
  std::vector<std::string> search_paths;         ///< Folders that its packages are looked for in.
  std::map<std::string, double> joints;          ///< [rad], [m] Positions; all others are at 0.
};

/// The world.
struct WorldChoice {
  std::string file = "lab";  ///< A world's name, its path, an SDF world, or a ROS map's YAML file.
  std::vector<std::string> search_paths;  ///< Folders that an SDF's models are looked for in.
  std::optional<sim::DifferenceSpec> differences;  ///< Instead of those of the world's file.
  bool strict = false;  ///< A piece of an SDF world that cannot be read is an error.
};

/// Where the robot starts, and what the localizers are told.
struct StartSpec {
  enum class Place { kWorld, kPose, kRandom };

  Place place = Place::kWorld;          ///< The world's own start; random where it has none.
  Eigen::Vector3d pose{0.0, 0.0, 0.0};  ///< x [m], y [m], yaw [rad] of base in map, for kPose.
  bool known = true;                    ///< False: the localizers start anywhere on the map.
  double sigma_m = 0.1;                 ///< [m] Uncertainty that a known start is given with...
  double sigma_yaw = 0.05;              ///< [rad] ...and of its yaw.
  double switch_on_s = 0.0;  ///< [s] The run begins then, on the move; for an unknown start.
  /// What they are told is wrong by this, in base: x [m], y [m], yaw [rad].
  Eigen::Vector3d wrong_by{0.0, 0.0, 0.0};

  /// The localizers are told the truth.
  [[nodiscard]] bool told() const { return known && wrong_by.isZero(0.0); }
};

/// Where the robot drives.
struct DriveSpec {
  std::string route;      ///< A route of the world, "random", "explore" or "none"; empty: the first
                          ///< one, else random.
  std::string twist_log;  ///< File of recorded commands to drive by instead; empty: none.
  std::string by = "truth";  ///< "truth" or the name of a localizer.
  sim::TwistLimits limits;
  double wait_s = 0.0;  ///< [s] Stands still at first.
};

/// A lidar: what differs from its profile, or from the robot's description.
struct LidarSpec {
  std::string name;               ///< Of one of several; empty: every lidar of the description.
  std::string profile = "robot";  ///< "robot": as its description says, "ideal": the same without
                                  ///< any error, or a device of `lidars/`.
  YamlNode changes;               ///< Settings by their keys (`fields` of a lidar).

  /// Changes a setting.
  LidarSpec& set(const std::string& key, double value);
  LidarSpec& set(const std::string& key, const Eigen::Vector3d& value);
};

/// What happens to the robot and when.
struct EventSpecs {
  std::vector<sim::KidnapSpec> kidnaps;
  std::vector<sim::FaultSpec> faults;
  std::string watched;  ///< Localizer that kidnaps on being localized go by; empty: none does.
};

/// People, and how they are logged.
struct PeopleSpec {
  sim::PeopleConfig config;
  double log_every_s = 0.5;  ///< [s] Between two rows of a person in people.csv; 0: no such file.
};

/// A localizer of the run.
struct LocalizerSpec {
  std::string name;  ///< Unique; names its files.
  std::variant<localization::MhAmclConfig, localization::PaperMhAmclConfig,
               localization::PublishedMhAmclConfig, localization::AmclConfig>
      config;
  /// Told of every kidnap: it starts anew, anywhere. All others must notice by themselves.
  bool relocalize_at_kidnap = false;
};

/// What the run leaves behind, besides its tables.
struct OutputSpec {
  bool snapshots = true;  ///< Pictures at all.
  PictureConfig pictures;
  bool report = true;                  ///< report.html
  bool player = true;                  ///< In the report, and the recording.gz that it plays.
  FilmConfig video;                    ///< With `castaway run --video FILE` only.
  bool scans = false;                  ///< scans.csv and labels.csv
  bool tables_csv = false;             ///< tables/*.csv
  bool tables_hdf5 = false;            ///< tables.h5
  double points_every_s = 0.0;         ///< [s] Between two PLY files of a lidar; 0: none.
  std::optional<BagOptions> bag;       ///< bag/; nothing: none.
  bool carmen = false;                 ///< log.carmen
  bool kitti = false;                  ///< kitti/
  bool map = false;                    ///< map/
  std::optional<CameraConfig> camera;  ///< camera/; nothing: none.
};

/// A run.
struct Scenario {
  std::string name;
  WorldChoice world;
  RobotSpec robot;
  std::uint64_t seed = 1;
  double duration_s = 120.0;  ///< [s]
  double stop_after_m = 0.0;  ///< [m] The run ends once so much is driven; 0: it does not.
  double physics_hz = 500.0;  ///< [Hz] Steps of the simulation.
  bool kinematic = false;     ///< The robot moves exactly as commanded; no masses, no contacts.
  double wall_height = 2.0;   ///< [m] Of a world made from a map.
  StartSpec start;
  DriveSpec drive;
  std::vector<LidarSpec> lidars{LidarSpec{}};  ///< One without a name, or all that there are.
  sim::OdometryConfig odometry;
  EventSpecs events;
  PeopleSpec people;
  std::vector<LocalizerSpec> localizers;
  OutputSpec outputs;
  std::vector<Expectation> expect;  ///< What a run must show; `castaway run` fails otherwise.
};

}  // namespace castaway::testbed
