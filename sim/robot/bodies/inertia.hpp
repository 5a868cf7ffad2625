/// Masses of links and their sum.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "sim/robot/urdf/robot_model.hpp"

namespace castaway::sim {

/// A rigid body's mass. Axes of base.
struct BodyMass {
  double mass = 0.0;                                     ///< [kg]
  Eigen::Vector3d p_base_com = Eigen::Vector3d::Zero();  ///< [m]
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();     ///< [kg m^2] About the centre of mass.
};

/// True if a body can have this inertia: principal moments above 0, none above the sum of the
/// others (by 1 %).
bool possible_inertia(const Eigen::Matrix3d& inertia);

/// The solid box around points, of a given mass; points without extent count as a ball of 2 cm.
BodyMass box_mass(const std::vector<Eigen::Vector3d>& points_base, double mass);

/// Bodies that move as one (parallel axes).
BodyMass lumped(const std::vector<BodyMass>& bodies);

}  // namespace castaway::sim
