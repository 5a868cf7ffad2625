/// Conversions between Eigen and Bullet. Internal to sim/world and sim/robot.
#pragma once

#include <LinearMath/btTransform.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace castaway::sim {

inline btVector3 to_bullet(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

inline btTransform to_bullet(const Eigen::Isometry3d& T) {
  const auto R = T.linear();
  const btMatrix3x3 basis(R(0, 0), R(0, 1), R(0, 2), R(1, 0), R(1, 1), R(1, 2), R(2, 0), R(2, 1),
                          R(2, 2));
  return btTransform(basis, to_bullet(Eigen::Vector3d(T.translation())));
}

inline Eigen::Isometry3d to_eigen(const btTransform& T) {
  Eigen::Isometry3d result = Eigen::Isometry3d::Identity();
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) {
      result.linear()(row, column) = T.getBasis()[row][column];
    }
  }
  result.translation() << T.getOrigin().x(), T.getOrigin().y(), T.getOrigin().z();
  return result;
}

}  // namespace castaway::sim
