/// A differential-drive robot as plain data, independent of the file format.
///
/// Frame base: on the floor below the root link, x forward, y left, z up. Links on fixed or locked
/// joints are part of the chassis; their frames are kept.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "sim/common/geometry.hpp"
#include "sim/world/world.hpp"

namespace castaway::sim {

/// The shape of a part of a robot.
using RobotShape = std::variant<BoxShape, CylinderShape, SphereShape, MeshShape>;

/// A collision or visual shape of a link.
struct RobotPart {
  std::string link;
  RobotShape shape;
  Eigen::Isometry3d T_base_part = Eigen::Isometry3d::Identity();  ///< With all joints at 0.
  /// RGB in [0, 1]; nothing: the mesh's own colour, or grey.
  std::optional<Eigen::Vector3f> color;
};

/// A driven wheel. Its axis is base's y.
struct DriveWheel {
  std::string joint;
  std::string link;
  Eigen::Vector3d p_base_wheel = Eigen::Vector3d::Zero();  ///< [m] Centre.
  double radius = 0.03;                                    ///< [m]
  double mass = 0.05;                                      ///< [kg]
  double inertia_spin = 1e-5;                              ///< [kg m^2] About the axis.
  double inertia_tilt = 1e-5;                              ///< [kg m^2] Across the axis.
  double effort_max = 0.0;                                 ///< [N m] 0: not given.
  double speed_max = 0.0;                                  ///< [rad/s] 0: not given.
};

/// A caster: a ball without friction that touches the floor.
struct Caster {
  Eigen::Vector3d p_base_caster = Eigen::Vector3d::Zero();  ///< [m] Centre; z is the radius.
  double radius = 0.01;                                     ///< [m]
};

/// A lidar as its sensor tag describes it.
struct LidarSpecs {
  int samples = 360;
  double angle_min = 0.0;       ///< [rad] First beam, about the laser's z from its x.
  double angle_max = 0.0;       ///< [rad] Last beam.
  double range_min = 0.0;       ///< [m]
  double range_max = 0.0;       ///< [m]
  double rate_hz = 0.0;         ///< [Hz] 0: not given.
  std::optional<double> sigma;  ///< [m] Gaussian range noise.
  int layers = 1;               ///< Number of layers; more than one: a 3-D lidar.
  double layer_min = 0.0;       ///< [rad] Elevation of the lowest layer.
  double layer_max = 0.0;       ///< [rad] Elevation of the highest layer.
};

/// The mount of a lidar.
struct LidarMount {
  std::string link;
  Eigen::Isometry3d T_base_laser = Eigen::Isometry3d::Identity();
  std::optional<LidarSpecs> specs;  ///< Nothing if it was found by its name only.
  std::string sensor{};  ///< Name of the sensor tag; empty if it was found by its link's name.
};

/// A robot. Its chassis is everything except the driven wheels.
struct RobotModel {
  std::string name;
  std::string path;                                      ///< The file it came from.
  double chassis_mass = 1.0;                             ///< [kg]
  Eigen::Vector3d p_base_com = Eigen::Vector3d::Zero();  ///< [m] Centre of mass of the chassis.
  /// [kg m^2] About the centre of mass, axes of base.
  Eigen::Matrix3d inertia = 0.01 * Eigen::Matrix3d::Identity();
  std::vector<RobotPart> collisions;  ///< Of the chassis.
  std::vector<RobotPart> visuals;     ///< Of all links.
  std::vector<DriveWheel> wheels;     ///< Two, or more for a skid steer.
  std::vector<Caster> casters;
  double wheel_radius = 0.03;  ///< [m] Mean of the driven wheels.
  /// [m] Effective in turns; for skid steers larger than the wheel separation.
  double track = 0.3;
  double wheel_separation = 0.3;          ///< [m] Between the centres of left and right wheels.
  Eigen::Vector2d p_base_axle{0.0, 0.0};  ///< [m] Centre of the drive axle; see `axle_twist`.
  std::string wheels_found_by;            ///< "kinematics", or the dialect of the plug-in tags.
  std::string other_drive;  ///< How the robot moves if not as simulated; see drive_kind.hpp.
  /// How it drives otherwise than its wheels would, as a sentence without its point; empty: it does
  /// not.
  std::string drive_note;
  std::optional<LidarMount> lidar;                  ///< The first of `lidars`.
  std::vector<LidarMount> lidars;                   ///< All lidars.
  double footprint_radius = 0.2;                    ///< [m] Disc about base's origin.
  double height = 0.2;                              ///< [m]
  std::map<std::string, Eigen::Isometry3d> frames;  ///< `T_base_link` of every link.
  std::vector<std::string> locked_joints;           ///< Joints that could move but are not driven.
  std::vector<std::string> warnings;                ///< What was repaired or guessed.
};

/// Velocity of the axle's centre when base moves by `twist`. If the axle lies to one side of base,
/// as with a skid steer with more load on one side, it moves forward or back as base turns.
inline Twist2 axle_twist(const Twist2& twist, const Eigen::Vector2d& p_base_axle) {
  return {twist.v - twist.w * p_base_axle.y(), twist.w};
}

}  // namespace castaway::sim
