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
#include "sim/difference/difference.hpp"
#include "sim/events/fault.hpp"
#include "sim/events/kidnap.hpp"
#include "sim/people/people_config.hpp"
#include "sim/sensor/gyro.hpp"
#include "tools/metrics/expectation.hpp"

namespace castaway::testbed {

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
  std::string by = "truth";            ///< "truth" or the name of a localizer.
  double max_speed = 0.5;              ///< [m/s]
  double max_turn_rate = 1.0;          ///< [rad/s]
  double max_acceleration = 0.5;       ///< [m/s^2] Speeding up and braking.
  double max_turn_acceleration = 2.0;  ///< [rad/s^2]
  double wait_s = 0.0;                 ///< [s] Stands still at first.
};

/// A lidar: what differs from its profile, or from the robot's description.
struct LidarSpec {
  std::string name;               ///< Of one of several; empty: the robot's only one.
  std::string profile = "robot";  ///< "robot": as its description says, "ideal": the same without
                                  ///< any error, or a device of `lidars/`.
  std::optional<int> beams;       ///< Over the same field of view.
  std::optional<double> angle_min_deg;       ///< [deg] Of the first beam.
  std::optional<double> fov_deg;             ///< [deg] From the first beam to the last.
  std::optional<double> range_min;           ///< [m]
  std::optional<double> range_max;           ///< [m]
  std::optional<double> rate_hz;             ///< [Hz]
  std::optional<double> range_sigma;         ///< [m] The same as noise.sigma_m.
  std::optional<bool> sweep;                 ///< Each beam at its own time; nothing: it does.
  std::vector<double> elevations_deg;        ///< [deg] Of the layers; none: as they are.
  std::optional<int> localize_layer;         ///< Which the localizers see; nothing: most level.
  std::optional<std::string> intensity;      ///< "none", "power" or "reflectivity".
  std::map<std::string, double> noise;       ///< By key, as in `lidar_noise.hpp`.
  std::optional<bool> glass;                 ///< Light passes glass.
  std::optional<Eigen::Vector3d> mount_xyz;  ///< [m] In base.
  std::optional<Eigen::Vector3d> mount_rpy;  ///< [rad] Roll, pitch, yaw in base.
};

/// Wheel odometry.
struct OdometrySpec {
  std::string profile = "default";      ///< A profile's name; the rest differs from it.
  std::optional<int> ticks_per_turn;    ///< 0: continuous.
  std::optional<double> radius_sigma;   ///< Relative.
  std::optional<double> track_sigma;    ///< Relative.
  std::optional<double> drift_along;    ///< [m/sqrt(m)]
  std::optional<double> drift_yaw_deg;  ///< [deg/sqrt(m)]
  std::map<std::string, double> slip;   ///< By key, as in `odometry_spec.hpp`.
  std::optional<bool> slip_zones;       ///< Wheels slip in the world's slip zones.
  std::optional<sim::GyroConfig> gyro;  ///< Nothing: the profile's, if it has one.
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
  std::variant<localization::MhAmclConfig, localization::AmclConfig> config;
  /// Told of every kidnap: it starts anew, anywhere. All others must notice by themselves.
  bool relocalize_at_kidnap = false;
};

/// A film of the run; where it goes is said on the command line.
struct VideoSpec {
  int width = 1280;            ///< [px] Even.
  int height = 720;            ///< [px] Even.
  int fps = 20;                ///< [1/s]
  double speed = 1.0;          ///< Seconds of the run in a second of film.
  std::string view = "chase";  ///< "chase" or "overview", with the map in a corner, or "map".
};

/// A bag of ROS 2 messages.
struct BagSpec {
  std::string compression = "zstd";  ///< "zstd", "lz4" or "none".
  bool particles = false;            ///< All particles of all localizers.
  bool snapshots = false;            ///< The run's pictures, if it takes any.
};

/// A camera on the robot.
struct CameraSpec {
  double rate_hz = 2.0;                                 ///< [Hz]
  int width = 640;                                      ///< [px]
  int height = 480;                                     ///< [px]
  double fov_deg = 70.0;                                ///< [deg] From left to right.
  Eigen::Vector3d mount_xyz{0.1, 0.0, 0.4};             ///< [m] In base.
  Eigen::Vector3d mount_rpy = Eigen::Vector3d::Zero();  ///< [rad]
  bool depth = true;                                    ///< camera/depth
  bool instances = true;                                ///< camera/instances
};

/// What the run leaves behind, besides its tables.
struct OutputSpec {
  bool snapshots = true;             ///< Pictures at all.
  double snapshot_every_s = 0.0;     ///< [s] 0: not by time.
  bool snapshot_on_events = true;    ///< At kidnaps and recoveries.
  int snapshot_width = 960;          ///< [px]
  int snapshot_height = 720;         ///< [px]
  bool report = true;                ///< report.html
  bool player = true;                ///< In the report, and the recording.gz that it plays.
  VideoSpec video;                   ///< With `castaway run --video FILE` only.
  bool scans = false;                ///< scans.csv and labels.csv
  bool tables_csv = false;           ///< tables/*.csv
  bool tables_hdf5 = false;          ///< tables.h5
  double points_every_s = 0.0;       ///< [s] Between two PLY files of a lidar; 0: none.
  std::optional<BagSpec> bag;        ///< bag/; nothing: none.
  bool carmen = false;               ///< log.carmen
  bool kitti = false;                ///< kitti/
  bool map = false;                  ///< map/
  std::optional<CameraSpec> camera;  ///< camera/; nothing: none.
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
  LidarSpec lidar;                ///< Changes every lidar of the robot's description...
  std::vector<LidarSpec> lidars;  ///< ...or these are all that there are.
  OdometrySpec odometry;
  EventSpecs events;
  PeopleSpec people;
  std::vector<LocalizerSpec> localizers;
  OutputSpec outputs;
  std::vector<Expectation> expect;  ///< What a run must show; `castaway run` fails otherwise.
};

}  // namespace castaway::testbed
