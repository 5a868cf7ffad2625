/// A scenario: all inputs of a run, as plain data with runnable defaults.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <Eigen/Core>

#include "localization/amcl/amcl.hpp"
#include "localization/mh_amcl/mh_amcl_config.hpp"
#include "localization/paper/published/published_config.hpp"
#include "sim/difference/difference.hpp"
#include "sim/events/event_lists.hpp"
#include "sim/people/people_config.hpp"
#include "sim/robot/bodies/twist_ramp.hpp"
#include "sim/sensor/further_sensors.hpp"
#include "sim/sensor/wheel_odometry.hpp"
#include "tools/outputs/pictures/picture_config.hpp"
#include "tools/ros/bag_options.hpp"
#include "tools/run/foreign_config.hpp"
#include "tools/run/localizer_order.hpp"
#include "tools/run/metrics/expectation.hpp"
#include "tools/run/ros2_config.hpp"
#include "tools/scenario/yaml/yaml_tree.hpp"

namespace castaway::testbed {

inline constexpr double kLongest = 1e7;   ///< [s] 115 days.
inline constexpr double kFarthest = 1e7;  ///< [m] UTM coordinates are smaller.

struct RobotSpec {
  std::string file = "waffle";                   ///< A robot's name, or a URDF or xacro file.
  std::map<std::string, std::string> arguments;  ///< Arguments of the xacro file.
  std::vector<std::string> search_paths;         ///< Folders in which its packages are searched.
  std::map<std::string, double> joints;          ///< [rad], [m] Positions; unlisted joints are at
                                                 ///< 0.
};

struct WorldChoice {
  std::string file = "lab";  ///< A world's name or path, an SDF world, or a ROS map's YAML file.
  std::vector<std::string> search_paths{};  ///< Folders in which an SDF's models are searched.
  std::optional<sim::DifferenceSpec> differences{};  ///< Overrides those of the world's file.
  /// ROS map given to the localizers; empty: a map of the world as it was.
  std::string map{};
  bool strict = false;  ///< An unreadable part of an SDF world is an error.
  /// Robots drive on all floors; overrides the world's file.
  std::optional<bool> levels{};
};

/// The start of the robot, and the start pose given to the localizers.
struct StartSpec {
  enum class Place { kWorld, kPose, kRandom };

  Place place = Place::kWorld;          ///< The world's own start; random if it has none.
  Eigen::Vector3d pose{0.0, 0.0, 0.0};  ///< x [m], y [m], yaw [rad] of base in map, for kPose.
  std::optional<int> level{};           ///< Of the start; empty: the lowest ground there.
  bool known = true;                    ///< False: the localizers start anywhere on the map.
  double sigma_m = 0.1;                 ///< [m] Stated uncertainty of a known start in x and y.
  double sigma_yaw = 0.05;              ///< [rad] Stated uncertainty of a known start in yaw.
  double switch_on_s = 0.0;  ///< [s] Time at which the run begins while the robot moves; for an
                             ///< unknown start.
  /// Error of the start pose given to the localizers, in base: x [m], y [m], yaw [rad].
  Eigen::Vector3d wrong_by{0.0, 0.0, 0.0};

  /// Whether the localizers are given the true start pose.
  [[nodiscard]] bool initializes() const { return known && wrong_by.isZero(0.0); }
};

/// The route or the commands that a robot follows.
struct DriveSpec {
  std::string route;         ///< A route of the world, "random", "explore" or "none"; empty: the
                             ///< world's first one, else random.
  std::string twist_log;     ///< File of recorded commands that replace the route; empty for none.
  std::string path;          ///< File of recorded poses that the robot follows; empty for none.
  std::string by = "truth";  ///< Pose that drives the robot: "truth" or the name of a localizer.
  sim::TwistLimits limits;
  double wait_s = 0.0;  ///< [s] Standstill at the beginning.

  [[nodiscard]] bool by_truth() const { return by == "truth"; }
};

/// A lidar: changes to its profile or to the robot's description.
struct LidarSpec {
  std::string name;               ///< Name of one of the robot's lidars; empty: every lidar of the
                                  ///< description.
  std::string profile = "robot";  ///< "robot": as described; "ideal": the same without errors; or a
                                  ///< device of `lidars/`.
  std::string scan_times;         ///< File with the times of the scans; empty: all the time.
  YamlNode changes;               ///< Settings by key (`fields` of a lidar).

  /// Changes a setting and returns the specification.
  LidarSpec& set(const std::string& key, double value);
  LidarSpec& set(const std::string& key, const Eigen::Vector3d& value);
};

/// Events of a run.
struct EventSpecs {
  sim::EventLists simulated;           ///< Carried out by the simulator.
  std::vector<LocalizerOrder> orders;  ///< In order of time.
  std::string watched;                 ///< Localizer that kidnaps wait for; empty: no kidnap waits.
};

/// People, and their log.
struct PeopleSpec {
  sim::PeopleConfig config;
  double log_every_s = 0.5;  ///< [s] Period of a person's rows in people.csv; 0: no file.
};

/// A localizer of the run.
struct LocalizerSpec {
  std::string name;  ///< Unique; used in file names.
  std::variant<localization::MhAmclConfig, localization::MhAmcl3dConfig,
               localization::PaperMhAmclConfig, localization::PublishedMhAmclConfig,
               localization::AmclConfig, ProgramConfig, LibraryConfig, OwnConfig, Ros2Config>
      config;
  /// If true, the localizer is notified of every kidnap and relocalizes globally. Otherwise it must
  /// notice a kidnap by itself.
  bool relocalize_at_kidnap = false;
};

/// Names of localizers, in their order.
std::vector<std::string> names_of(const std::vector<LocalizerSpec>& localizers);

/// Optional outputs of a run.
struct OutputSpec {
  bool snapshots = true;  ///< False disables all pictures.
  PictureConfig pictures;
  bool report = true;                  ///< report.html
  bool player = true;                  ///< The player in the report and its recording.gz.
  FilmConfig video;                    ///< Only with `castaway run --video FILE`.
  bool scans = false;                  ///< scans.csv and labels.csv
  bool tables_csv = false;             ///< tables/*.csv
  bool tables_hdf5 = false;            ///< tables.h5
  double points_every_s = 0.0;         ///< [s] Period of a lidar's PLY files; 0: none.
  std::optional<BagOptions> bag;       ///< bag/; nothing for none.
  bool carmen = false;                 ///< log.carmen
  bool kitti = false;                  ///< kitti/
  bool map = false;                    ///< map/
  std::optional<CameraConfig> camera;  ///< camera/; nothing for none.
};

struct Scenario {
  std::string name;
  WorldChoice world;
  RobotSpec robot;
  std::uint64_t seed = 1;
  double duration_s = 120.0;  ///< [s]
  double stop_after_m = 0.0;  ///< [m] The run ends after this driven distance; 0: no limit.
  double physics_hz = 500.0;  ///< [Hz] Rate of the simulation steps.
  bool kinematic = false;     ///< The robot moves exactly as commanded, without masses and
                              ///< contacts.
  double wall_height = 2.0;   ///< [m] For a world made from a map.
  StartSpec start;
  DriveSpec drive;
  std::vector<LidarSpec> lidars{LidarSpec{}};  ///< One without a name, or all lidars of the run.
  sim::OdometryConfig odometry;
  sim::FurtherSensors sensors;
  EventSpecs events;
  PeopleSpec people;
  std::vector<LocalizerSpec> localizers;
  OutputSpec outputs;
  std::vector<Expectation> expect;  ///< Expectations; if one is not met, `castaway run` fails.
};

}  // namespace castaway::testbed
