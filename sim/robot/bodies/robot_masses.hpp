/// Masses of a robot's wheels and chassis. Internal to sim/robot.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "sim/robot/urdf/robot_model.hpp"
#include "sim/robot/urdf/urdf_parts.hpp"

namespace castaway::sim {

/// Mass properties of a rigid body, with the axes of base.
struct BodyMass {
  double mass = 0.0;                                     ///< [kg]
  Eigen::Vector3d p_base_com = Eigen::Vector3d::Zero();  ///< [m]
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();     ///< [kg m^2] About the centre of mass.
};

/// True if a body can have this inertia: its principal moments are positive, and none exceeds the
/// sum of the other two by more than 1 %.
bool possible_inertia(const Eigen::Matrix3d& inertia);

/// Mass properties of the solid box around points; points without extent count as a box of 2 cm.
BodyMass box_mass(const std::vector<Eigen::Vector3d>& points_base, double mass);

/// Mass properties of several bodies that move as one (parallel axis theorem).
BodyMass lump(const std::vector<BodyMass>& bodies);

/// Mass of a link in base. If the file gives none, or an impossible one, it is that of the box
/// around `points_base` (the link's shape), with a warning. A link without shape and mass is a mere
/// frame and weighs nothing.
BodyMass link_mass(const urdf::Link& link, const LinkFrames& frames,
                   const std::vector<Eigen::Vector3d>& points_base,
                   std::vector<std::string>& warnings);

/// Sets the masses of a robot whose wheels and parts are known. Links without <inertial> weigh
/// nothing (many files put the whole mass into one link). If that makes the chassis lighter than
/// the wheels, the masses of these links are guessed from their shapes, with a warning.
/// @throws std::runtime_error if there are only wheels.
void add_masses(const UrdfFile& file, const LinkFrames& frames, RobotModel& robot);

/// [N] Load of a driven wheel if all wheels carry the same and nothing else carries: the robot's
/// weight divided by their number.
double wheel_load(const RobotModel& robot);

}  // namespace castaway::sim
