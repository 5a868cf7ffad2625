/// Masses and inertia of bodies.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "sim/robot/urdf/robot_model.hpp"

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

}  // namespace castaway::sim
